// Solutions that several benchmarks start from.
#pragma once

#include "iteration/solver.h"
#include "scene/bundled.h"

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

} // namespace penumbra
