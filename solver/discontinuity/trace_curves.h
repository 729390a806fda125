// The discontinuity curves of a scene's emitters.
#pragma once

#include "core/cancel.h"
#include "core/counters.h"
#include "discontinuity/curve.h"
#include "scene/scene.h"

#include <span>
#include <vector>

namespace penumbra {

/// Curves that light from `source`, past `blockers`, throws on `receiver` (Heckbert 1992; Lischinski, Tampieri &
/// Greenberg 1992; Drettakis & Fiume 1994): VE, EV, EEE, plane and contact, each only where it is real, those that coincide
/// merged (merge_curves.h). `blockers` is a superset of the surfaces that may stand between the two; they block from
/// both sides.
/// tests/discontinuity checks them, both ways, against changes of the visible part found with no critical surface.
/// `switches` turn kinds off, or on where there are too few blockers for them. Throws Cancelled when `cancel` is raised.
std::vector<Curve> trace_curves(const Scene &scene, SurfaceId source, SurfaceId receiver,
                                std::span<const SurfaceId> blockers, const Cancel *cancel = nullptr,
                                const EffectSwitches &switches = {});

/// Curves of all emitters on all receivers that reflect, by receiver, then by source. Runs in parallel; the result does
/// not depend on the number of threads. Pairs that were traced, and those that were not though a switch could ask for it,
/// are counted in `work`. Throws Cancelled when `cancel` is raised.
std::vector<Curve> trace_emitter_curves(const Scene &scene, const EffectSwitches &switches, Work &work,
                                        const Cancel *cancel = nullptr);
std::vector<Curve> trace_emitter_curves(const Scene &scene, const Cancel *cancel = nullptr);

/// Surfaces that may stand between the two: those that reach into the box about both.
std::vector<SurfaceId> possible_blockers(const Scene &scene, SurfaceId source, SurfaceId receiver);

} // namespace penumbra
