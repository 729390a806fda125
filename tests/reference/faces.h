// Scenes written down in a test, face by face.
#pragma once

#include "scene/build_scene.h"
#include "scene/scene.h"

#include <memory>
#include <vector>

namespace penumbra::reference {

/// A polygon, counter-clockwise seen from its front, in the test's own frame.
struct Face {
    std::vector<Vec3> corners;
    Rgb reflectance = Rgb::Constant(0.5);
    Rgb exitance = Rgb::Zero();
};

/// The scene of these faces: surface i is face i. Throws BadInput where a reader would.
std::shared_ptr<const Scene> scene_of(const std::vector<Face> &faces);

/// Six faces of the box spanned by a, b, c from its corner, looking outwards when a, b, c are right-handed.
std::vector<Face> box(const Vec3 &corner, const Vec3 &a, const Vec3 &b, const Vec3 &c, const Rgb &reflectance,
                      const Rgb &exitance = Rgb::Zero());

/// The same faces looking the other way.
std::vector<Face> turned_over(std::vector<Face> faces);

} // namespace penumbra::reference
