#include "scene/move_object.h"

#include "core/error.h"
#include "scene/build_scene.h"

#include <cmath>
#include <limits>
#include <utility>

namespace penumbra {

namespace {

bool is_double_sided(const Scene &scene, const Surface &front) {
    for (const Surface &s : scene.surfaces)
        if (s.back && s.face == front.face)
            return true;
    return false;
}

/// As a reader would have given it: a face for each surface, so that surfaces keep their numbers.
RawScene raw_from(const Scene &scene) {
    RawScene raw;
    raw.name = scene.name;
    raw.file = scene.file;
    raw.materials = scene.materials;
    raw.up = scene.up;
    for (const Surface &s : scene.surfaces) {
        if (s.back)
            continue;
        RawFace face{s.name, scene.name + ", surface " + std::to_string(raw.faces.size()), s.material,
                     is_double_sided(scene, s), {}};
        for (const Vec3 &x : s.corners)
            face.corners.push_back(scene.own.to_own(x));
        raw.faces.push_back(std::move(face));
    }
    return raw;
}

void check(const Scene &scene, const ObjectMove &move) {
    const std::string which = scene.name + ": surface " + std::to_string(move.surface);
    if (move.surface < 0 || move.surface >= scene.n_surfaces())
        throw BadInput(which + " is to be moved, but there are " + std::to_string(scene.n_surfaces()));
    if (!move.offset.allFinite() || !std::isfinite(move.scale) || !(move.scale > 0))
        throw BadInput(which + " cannot be moved so; give finite numbers, and a scale above 0");
}

} // namespace

std::vector<int> object_surfaces(const Scene &scene, SurfaceId surface) {
    const Surface &chosen = scene.surface(surface);
    std::vector<int> all;
    for (int s = 0; s < scene.n_surfaces(); ++s) {
        const Surface &other = scene.surfaces[static_cast<std::size_t>(s)];
        const bool same = chosen.name.empty() ? other.face == chosen.face : other.name == chosen.name;
        if (same && !other.back)
            all.push_back(s);
    }
    return all;
}

Vec3 object_centre(const Scene &scene, SurfaceId surface) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const int s : object_surfaces(scene, surface))
        for (const Vec3 &x : scene.surfaces[static_cast<std::size_t>(s)].corners) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
    return scene.own.to_own(0.5 * (low + high));
}

Scene with_moves(const Scene &scene, std::span<const ObjectMove> moves) {
    RawScene raw = raw_from(scene);
    for (const ObjectMove &move : moves) {
        check(scene, move);
        const Vec3 centre = object_centre(scene, SurfaceId(move.surface));
        for (const int s : object_surfaces(scene, SurfaceId(move.surface)))
            for (Vec3 &x : raw.faces[static_cast<std::size_t>(s)].corners)
                x = centre + move.offset + move.scale * (x - centre);
    }
    Scene moved = build_scene(std::move(raw));
    moved.description = scene.description;
    moved.view = scene.view;
    return moved;
}

} // namespace penumbra
