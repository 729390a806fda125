#include "iteration/truth.h"

#include <utility>

namespace penumbra {

Truth truth_of(std::shared_ptr<const Scene> scene, std::shared_ptr<const Reference> reference) {
    const double error = reference->error();
    return {[scene = std::move(scene), reference = std::move(reference)](int surface, const Vec2 &point) {
                return reference->radiosity_at(SurfaceId(surface), point / scene->own.size);
            },
            error};
}

} // namespace penumbra
