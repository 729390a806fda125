#include "visibility/ray_scene.h"

#include "visibility/embree.h"

#include <limits>
#include <vector>

namespace penumbra {

struct RayScene::Tree {
    EmbreeDevice device{rtcNewDevice(nullptr)};
    EmbreeScene scene;
    std::vector<SurfaceId> front_of, back_of; // by triangle
};

namespace {

void intersect(RTCScene scene, RTCRayHit &ray) {
#if RTC_VERSION_MAJOR >= 4
    rtcIntersect1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}

} // namespace

RayScene::RayScene(const Scene &scene) : tree_(std::make_unique<Tree>()) {
    // The back of a double-sided face lies where its front lies: one set of triangles serves both.
    std::vector<int> back_by_face;
    for (int s = 0; s < scene.n_surfaces(); ++s)
        if (const Surface &surface = scene.surface(SurfaceId(s)); surface.back) {
            back_by_face.resize(std::max(back_by_face.size(), static_cast<std::size_t>(surface.face) + 1), -1);
            back_by_face[static_cast<std::size_t>(surface.face)] = s;
        }
    std::vector<Vec3> corners;
    std::vector<unsigned> triangles;
    for (int s = 0; s < scene.n_surfaces(); ++s) {
        const Surface &surface = scene.surface(SurfaceId(s));
        if (surface.back)
            continue;
        const auto face = static_cast<std::size_t>(surface.face);
        const int back = face < back_by_face.size() && back_by_face[face] >= 0 ? back_by_face[face] : s;
        for (const Polygon &part : surface.parts)
            for (std::size_t i = 1; i + 1 < part.size(); ++i) {
                for (const Vec2 &p : {part[0], part[i], part[i + 1]}) {
                    triangles.push_back(static_cast<unsigned>(corners.size()));
                    corners.push_back(surface.frame.to_space(p));
                }
                tree_->front_of.push_back(SurfaceId(s));
                tree_->back_of.push_back(SurfaceId(back));
            }
    }
    tree_->scene.reset(rtcNewScene(tree_->device.get()));
    rtcSetSceneFlags(tree_->scene.get(), RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(tree_->device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto *vertices = static_cast<float *>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                  3 * sizeof(float), corners.size()));
    for (const Vec3 &c : corners)
        for (const double x : {c.x(), c.y(), c.z()})
            *vertices++ = static_cast<float>(x);
    auto *indices = static_cast<unsigned *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size() / 3));
    for (const unsigned i : triangles)
        *indices++ = i;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(tree_->scene.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(tree_->scene.get());
}

RayScene::~RayScene() = default;

std::optional<RayHit> RayScene::nearest(const Vec3 &origin, const Vec3 &direction, double from) const {
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(origin.x());
    ray.ray.org_y = static_cast<float>(origin.y());
    ray.ray.org_z = static_cast<float>(origin.z());
    ray.ray.dir_x = static_cast<float>(direction.x());
    ray.ray.dir_y = static_cast<float>(direction.y());
    ray.ray.dir_z = static_cast<float>(direction.z());
    ray.ray.tnear = static_cast<float>(from);
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    intersect(tree_->scene.get(), ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return std::nullopt;
    // Embree's normal of a counter-clockwise triangle looks to the front.
    const Vec3 normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
    const bool front = normal.dot(direction) < 0;
    const std::size_t triangle = ray.hit.primID;
    const SurfaceId back = tree_->back_of[triangle];
    const bool has_back = back != tree_->front_of[triangle];
    return RayHit{front ? tree_->front_of[triangle] : back, ray.ray.tfar, front || has_back};
}

} // namespace penumbra
