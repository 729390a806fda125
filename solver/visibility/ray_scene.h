// Rays through the scene (Embree, single precision): for picking, display and independent checks, never for transport.
#pragma once

#include "core/ids.h"
#include "scene/scene.h"

#include <memory>
#include <optional>

namespace penumbra {

struct RayHit {
    SurfaceId surface;     ///< the input surface; of a double-sided face the side that the ray came from
    double distance = 0;   ///< along the ray, in units of its direction's length
    bool front = false;    ///< whether the ray met the front side
};

/// The scene as triangles with Embree's robust traversal: no ray slips through a shared edge. Of surfaces in one plane the
/// one that lies on top is met (scene/covers.h). Keeps a reference to the scene.
class RayScene {
public:
    explicit RayScene(const Scene &scene);
    ~RayScene();
    RayScene(const RayScene &) = delete;
    RayScene &operator=(const RayScene &) = delete;

    /// The nearest hit beyond `from`, in solver coordinates; none when the ray leaves the scene. Safe from many threads.
    std::optional<RayHit> nearest(const Vec3 &origin, const Vec3 &direction, double from = 1e-6) const;

private:
    struct Tree;
    const Scene &scene_;
    std::unique_ptr<Tree> tree_;
};

} // namespace penumbra
