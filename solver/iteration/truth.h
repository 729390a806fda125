// What radiosity on a scene really is, in the frame that snapshots have.
#pragma once

#include "core/cancel.h"
#include "iteration/snapshot.h"
#include "measure/reference.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace penumbra {

/// Immutable; may be asked from several threads.
struct Truth {
    std::function<Rgb(int surface, const Vec2 &point)> radiosity_at; ///< B [W/m2] at a point of the surface's plane
    double error = 0;                                                ///< its own relative L2 error, about; 0: exact
    std::optional<EffectChange> change{}; ///< no truth, but a solution with this one effect switched otherwise
    std::uint64_t version = 0;            ///< no truth, but what the snapshot of this version shows; 0: no snapshot

    bool is_a_solution() const { return change || version > 0; }
};

/// A reference (measure/reference.h) asked in the scene's own frame.
Truth truth_of(std::shared_ptr<const Scene> scene, std::shared_ptr<const Reference> reference);

/// In place of the truth: the solution by the same options but for one switch, brought to its end. What a solution misses of
/// it is what the effect changes. `told` hears of every step. Throws Cancelled.
Truth with_change(std::shared_ptr<const Scene> scene, Options options, const EffectChange &change,
                  const Cancel *cancel = nullptr, const std::function<void(const Counters &)> &told = {});

/// In place of the truth: what another snapshot of the same scene shows. What a solution misses of it is the difference of
/// the two, that one minus this one.
Truth truth_in(std::shared_ptr<const Snapshot> snapshot);

} // namespace penumbra
