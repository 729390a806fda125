// Solutions that several benchmarks start from.
#pragma once

#include "iteration/solver.h"
#include "scene/bundled.h"
#include "study/solve_for_reference.h"
#include "study/true_error.h"

namespace penumbra {

inline std::shared_ptr<const Scene> bundled(const char *scene) {
    return std::make_shared<const Scene>(open_scene(scene));
}

inline Options options_of(Strategy strategy, double threshold) {
    Options options;
    options.strategy = strategy;
    options.threshold = threshold;
    return options;
}

/// The relative L2 error of B - E; where light bounces more than once against a reference from a solution to `tolerance`.
inline TrueError true_error(const std::shared_ptr<const Scene> &scene, double tolerance) {
    std::shared_ptr<const Reference> reference;
    if (!has_one_bounce(*scene))
        reference = std::make_shared<const Reference>(scene, solve_for_reference(scene, tolerance));
    return error_against(scene, reference);
}

} // namespace penumbra
