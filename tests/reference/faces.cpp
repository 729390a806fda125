#include "reference/faces.h"

#include <algorithm>

namespace penumbra::reference {

std::shared_ptr<const Scene> scene_of(const std::vector<Face> &faces) {
    RawScene raw;
    raw.name = "test";
    for (const Face &face : faces) {
        const auto number = std::to_string(raw.faces.size());
        raw.materials.push_back({"material " + number, face.reflectance, face.exitance});
        raw.faces.push_back(
            {"face " + number, "test:" + number, static_cast<int>(raw.faces.size()), false, face.corners});
    }
    return std::make_shared<const Scene>(build_scene(std::move(raw)));
}

std::vector<Face> box(const Vec3 &o, const Vec3 &a, const Vec3 &b, const Vec3 &c, const Rgb &reflectance,
                      const Rgb &exitance) {
    const std::vector<std::vector<Vec3>> sides{
        {o, o + b, o + a + b, o + a}, {o + c, o + c + a, o + a + b + c, o + b + c},
        {o, o + a, o + a + c, o + c}, {o + b, o + b + c, o + a + b + c, o + a + b},
        {o, o + c, o + b + c, o + b}, {o + a, o + a + b, o + a + b + c, o + a + c}};
    std::vector<Face> faces;
    for (const auto &corners : sides)
        faces.push_back({corners, reflectance, exitance});
    return faces;
}

std::vector<Face> turned_over(std::vector<Face> faces) {
    for (Face &face : faces)
        std::ranges::reverse(face.corners);
    return faces;
}

} // namespace penumbra::reference
