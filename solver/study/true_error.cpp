#include "study/true_error.h"

#include "iteration/solver.h"
#include "measure/direct.h"

#include <utility>

namespace penumbra {

TrueError error_against(std::shared_ptr<const Scene> scene, std::shared_ptr<const Reference> reference) {
    if (!has_one_bounce(*scene))
        return [scene = std::move(scene), reference = std::move(reference)](const State &state) {
            return error_against(*reference, *scene, {state.forest, state.radiosity}, 4096);
        };
    const auto blockers = std::make_shared<const Blockers>(*scene);
    return [scene = std::move(scene), blockers](const State &state) {
        return direct_error(*scene, *blockers, state.forest, state.radiosity);
    };
}

} // namespace penumbra
