#include "study/true_error.h"

#include "iteration/solver.h"
#include "measure/direct.h"

namespace penumbra {

TrueError error_against_direct_light(const std::shared_ptr<const Scene> &scene) {
    if (!has_one_bounce(*scene))
        return {};
    const auto blockers = std::make_shared<const Blockers>(*scene);
    return [=](const State &state) { return direct_error(*scene, *blockers, state.forest, state.radiosity); };
}

} // namespace penumbra
