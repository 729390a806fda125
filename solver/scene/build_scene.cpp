#include "scene/build_scene.h"

#include "core/error.h"
#include "scene/covers.h"
#include "scene/mend.h"
#include "scene/normalise.h"
#include "scene/validate.h"

#include <algorithm>

namespace penumbra {

namespace {

Surface make_surface(const RawFace &face, int number, std::vector<Vec3> corners) {
    Surface surface;
    surface.name = face.object;
    surface.face = number;
    surface.material = face.material;
    surface.frame = plane_frame(corners);
    for (const Vec3 &x : corners)
        surface.outline.push_back(surface.frame.to_plane(x));
    surface.corners = std::move(corners);
    surface.area = area(surface.outline);
    surface.parts = convex_parts(surface.outline);
    return surface;
}

Surface back_of(const Surface &front, const RawFace &face) {
    Surface back = make_surface(face, front.face, {front.corners.rbegin(), front.corners.rend()});
    back.back = true;
    return back;
}

} // namespace

Scene build_scene(RawScene raw) {
    check_faces(raw);
    check_materials(raw);
    Scene scene;
    scene.own = normalise(raw);
    Notes notes;
    for (std::size_t i = 0; i < raw.faces.size(); ++i)
        for (auto &loop : mend(raw.faces[i], notes))
            scene.surfaces.push_back(make_surface(raw.faces[i], static_cast<int>(i), std::move(loop)));
    if (scene.surfaces.empty())
        throw BadInput(raw.file.string() + ": has no surface; none of its faces has an area");
    // Backs come after all fronts, so that a face's number and its back's differ by the number of faces.
    for (std::size_t i = 0, n_fronts = scene.surfaces.size(); i < n_fronts; ++i) {
        const RawFace &face = raw.faces[static_cast<std::size_t>(scene.surfaces[i].face)];
        if (face.double_sided)
            scene.surfaces.push_back(back_of(scene.surfaces[i], face));
    }
    notes.append_to(raw.notes);
    scene.name = std::move(raw.name);
    scene.file = std::move(raw.file);
    scene.materials = std::move(raw.materials);
    scene.up = raw.up;
    scene.notes = std::move(raw.notes);
    find_covers(scene);
    const bool dark = std::ranges::none_of(scene.surfaces, [&](const Surface &s) {
        return scene.materials[static_cast<std::size_t>(s.material)].exitance.maxCoeff() > 0;
    });
    if (dark) // first, as it is what a black picture asks for
        scene.notes.insert(scene.notes.begin(), scene.file.string() + ": nothing emits (no face's material has a " +
                                                  raw.exitance_key + " above 0): the scene is dark");
    return scene;
}

} // namespace penumbra
