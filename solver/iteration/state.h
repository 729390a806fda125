// Everything that a solution is, between two phases.
#pragma once

#include "core/counters.h"
#include "discontinuity/curve_index.h"
#include "discontinuity/hidden_pairs.h"
#include "effects/plan.h"
#include "hierarchy/push_pull.h"
#include "iteration/link_batch.h"
#include "iteration/snapshot.h"
#include "iteration/split_event.h"
#include "transport/interaction.h"
#include "visibility/ray_scene.h"

#include <memory>
#include <string>
#include <vector>

namespace penumbra {

/// What does not change from step to step: the scene with its blockers.
struct Setting {
    std::shared_ptr<const Scene> scene;
    Options options;
    std::unique_ptr<const Blockers> blockers{};
    std::unique_ptr<const RayScene> rays{}; ///< for the error's estimate; null: light bounces once, or nothing blocks it
    Plan plan{};
    std::unique_ptr<const HiddenPairs> hidden_pairs{}; ///< null: looked at one by one

    const Rgb &reflectance(SurfaceId s) const { return scene->reflectance(s); }
    bool one_bounce() const { return !rays && (plan.anything_blocks() || !plan.interreflection); }
    double largest_reflectance() const; ///< of all surfaces and channels
    /// Links are made to a tenth of the threshold in force, or of twice the tolerance (0.001 where that is 0) if that
    /// is smaller. What they miss is reflected again and again, 1 / (1 - rho) times in all:
    /// beyond a reflectance of 0.9 what a constant source brings gets the digits that this takes. Details of radiosity are
    /// of the size of the first bounces; what they bring is not worth it.
    Transport transport(double threshold, const Cancel *cancel) const;
};

/// Immutable once a phase is complete. Interactions are shared with the states before and after.
struct State {
    Phase phase = Phase::start;
    Counters counters;
    Forest forest;
    std::vector<std::vector<std::shared_ptr<const Interaction>>> interactions; ///< by receiver element
    std::vector<std::shared_ptr<const LinkBatch>> batches; ///< of the interactions, by receiver; renewed by the gather
    std::vector<std::vector<char>> linked; ///< [receiver surface][source surface]: its root pairs were dealt with
    /// Curves of all emitters, and of those reflectors whose light needed them; only ever added to, at the end.
    std::shared_ptr<const CurveIndex> curves;
    std::shared_ptr<const std::vector<SnapshotCurve>> drawn_curves; ///< the same ones
    std::vector<std::vector<char>> traced; ///< [receiver surface][source surface]: their curves are there
    int n_untraced = 0; ///< pairs of these that got none, too much standing between them
    Coefficients irradiance;               ///< as gathered, at each level
    Coefficients radiosity;                ///< at each level, the upper ones pulled from the leaves
    Coefficients shot; ///< GatherOrder::southwell: the radiosity that `irradiance` came from; else empty
    double peak = 0;                       ///< largest reflected radiosity B - E, largest channel [W/m2]
    std::string sentence;                  ///< what the last phase did
    std::shared_ptr<const RefineEvents> events; ///< of the refinement, if that was the last phase; else null
};

/// Each of the three phases takes the state before it and leaves the state after it; all can be cancelled.

/// Links new pairs, tests all T_S with the oracle, splits the nodes that failed, and links their children.
void refine(const Setting &setting, State &state, const Cancel *cancel);
/// What these radiosities bring to every element by its own links: the sum over them of K b. Of the batches, which must be
/// those of the interactions (as after a gather).
Coefficients gathered(const State &state, const Coefficients &radiosity, const Cancel *cancel);
/// irradiance = sum over the links of K b, at the level of each link; which b, Options::gather says (relaxation.h).
void gather(const Setting &setting, State &state, const Cancel *cancel);
/// Irradiance down to the leaves, radiosity up; the change, the peak and whether the iteration has converged.
void push_pull(const Setting &setting, State &state);

} // namespace penumbra
