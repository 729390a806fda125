#include "visibility/ray_scene.h"

#include "scene/covers.h"
#include "visibility/embree.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace penumbra {

struct RayScene::Tree {
    EmbreeDevice device{rtcNewDevice(nullptr)};
    EmbreeScene scene;
    std::vector<SurfaceId> front_of, back_of; // by triangle
    std::vector<std::vector<SurfaceId>> same_plane; // by surface that has covers: others there that face its way
};

namespace {

/// Whether x, in the surface's plane, lies in it.
bool holds(const Surface &surface, const Vec3 &x) {
    const Vec2 at = surface.frame.to_plane(x);
    return std::ranges::any_of(surface.parts, [&](const Polygon &part) { return contains(part, at); });
}

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

RayScene::RayScene(const Scene &scene) : scene_(scene), tree_(std::make_unique<Tree>()) {
    tree_->same_plane.resize(scene.surfaces.size());
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
        if (const Surface &surface = scene.surfaces[s]; !surface.covers.empty())
            for (int other = 0; other < scene.n_surfaces(); ++other)
                if (SurfaceId(other) != SurfaceId(s) && in_one_plane(surface, scene.surface(SurfaceId(other))) &&
                    surface.frame.normal.dot(scene.surface(SurfaceId(other)).frame.normal) > 0)
                    tree_->same_plane[s].emplace_back(other);
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
    RayHit hit{front ? tree_->front_of[triangle] : back, ray.ray.tfar, front || has_back};
    // Of surfaces in one plane any may be met: the one that lies on top is meant.
    if (hit.front && !tree_->same_plane[hit.surface.at()].empty()) {
        const Vec3 at = origin + hit.distance * direction;
        const auto shows = [&](const Surface &s) { return !is_covered(s, s.frame.to_plane(at)); };
        if (!shows(scene_.surface(hit.surface)))
            for (const SurfaceId other : tree_->same_plane[hit.surface.at()])
                if (const Surface &s = scene_.surface(other); holds(s, at) && shows(s))
                    hit.surface = other;
    }
    return hit;
}

} // namespace penumbra
