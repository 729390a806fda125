// The curves that a solution knows: of all emitters from the start, of reflectors when their light is worth it.
#pragma once

#include "core/cancel.h"
#include "iteration/state.h"

#include <vector>

namespace penumbra {

/// Light from one surface on another.
struct LightPath {
    SurfaceId receiver, source;

    auto operator<=>(const LightPath &) const = default;
};

/// Gives a new state the curves of all emitters. Throws Cancelled.
void trace_emitters(const Setting &setting, State &state, const Cancel *cancel);

/// Adds the curves that the sources of these pairs throw on their receivers, in the pairs' ascending order, those of each
/// pair once (Lischinski, Tampieri & Greenberg 1993 make them lazily, too, link by link). Runs in parallel over the
/// pairs; the result does not depend on the number of threads. Known curves keep their ids, and states that share them
/// are not touched. A pair with more than 60 surfaces that may stand between the two gets none and is counted in
/// State::n_untraced: tracing them can take seconds (on `office` 4.7 s for the floor's light on a wall past 78 surfaces,
/// 0.1 s past 50). Pairs
/// are counted in the state's work. Throws Cancelled and leaves the state as it was. tests/agreement/reflector_curves_test.cpp.
void trace_paths(const Setting &setting, State &state, std::vector<LightPath> paths, const Cancel *cancel);

} // namespace penumbra
