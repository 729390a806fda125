#include "scene/validate.h"

#include "core/error.h"
#include "core/read_text.h"

#include <cmath>
#include <fmt/format.h>

namespace penumbra {

std::string who(const RawFace &face) {
    return face.where + ": face" + (face.object.empty() ? "" : " of " + in_quotes(face.object));
}

void FaceCount::add(const std::string &file, std::size_t n_corners) {
    if (++n_faces_ > most_faces)
        throw BadInput(fmt::format("{}: has more than {} faces; simplify the scene", file, most_faces));
    if ((n_corners_ += n_corners) > most_corners_in_all)
        throw BadInput(
            fmt::format("{}: has more than {} corners of faces; simplify the scene", file, most_corners_in_all));
}

void check_faces(const RawScene &raw) {
    if (raw.faces.empty())
        throw BadInput(raw.file.string() + ": has no surface; give at least one face of three corners");
    for (const RawFace &face : raw.faces) {
        if (face.corners.size() > most_corners)
            throw BadInput(
                fmt::format("{} has {} corners, more than {}; split it", who(face), face.corners.size(), most_corners));
        if (face.material < 0 || static_cast<std::size_t>(face.material) >= raw.materials.size())
            throw BadInput(fmt::format("{} has material {} of {}; give an index in range", who(face), face.material,
                                       raw.materials.size()));
        for (const Vec3 &x : face.corners)
            if (!x.allFinite())
                throw BadInput(fmt::format("{} has a corner ({}, {}, {}) that is not finite; give finite coordinates",
                                           who(face), x.x(), x.y(), x.z()));
    }
}

void check_materials(const RawScene &raw) {
    std::vector<const RawFace *> user(raw.materials.size());
    for (const RawFace &face : raw.faces)
        if (const RawFace *&first = user[static_cast<std::size_t>(face.material)]; !first)
            first = &face;
    for (std::size_t m = 0; m < user.size(); ++m) {
        if (!user[m])
            continue;
        const Material &material = raw.materials[m];
        const auto fail = [&](const std::string &what) {
            throw BadInput(fmt::format("{}: material {}: {}", user[m]->where, in_quotes(material.name), what));
        };
        for (const double rho : material.reflectance)
            if (!(rho >= 0 && rho < 1)) // a nan fails both
                fail(fmt::format("reflectance ({}) {:g} is outside [0, 1); give less than 1, say 0.8",
                                 raw.reflectance_key, rho));
        for (const double e : material.exitance)
            if (!(e >= 0 && std::isfinite(e)))
                fail(
                    fmt::format("exitance ({}) {:g} is negative or not finite; give W/m2 from 0", raw.exitance_key, e));
    }
}

} // namespace penumbra
