#include "fuzz/sound.h"

#include "core/error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace penumbra::fuzz {

void expect(bool holds, const char *what, const std::string &where) {
    if (holds)
        return;
    std::fprintf(stderr, "not sound: %s: %s\n", what, where.c_str());
    std::abort();
}

void expect_one_line(const std::string &message) {
    expect(!message.empty() && message.size() < 2000, "a message is empty or endless", message);
    expect(std::ranges::none_of(message, [](unsigned char c) { return c < 0x20 || c == 0x7f; }),
           "a message has control characters", message);
}

namespace {

void expect_sound_surface(const Surface &surface, const Scene &scene) {
    expect(surface.corners.size() >= 3 && surface.outline.size() == surface.corners.size(), "corners", surface.name);
    for (const Vec3 &x : surface.corners)
        expect(x.allFinite() && x.norm() <= 1, "a corner is outside the unit size", surface.name);
    expect(surface.frame.normal.allFinite() && std::abs(surface.frame.normal.norm() - 1) < 1e-9, "normal",
           surface.name);
    expect(std::isfinite(surface.area) && surface.area > 0, "area", surface.name);
    double tiled = 0;
    for (const Polygon &part : surface.parts)
        tiled += area(part);
    expect(std::abs(tiled - surface.area) <= 1e-9, "parts do not tile the outline", surface.name);
    expect(surface.material >= 0 && static_cast<std::size_t>(surface.material) < scene.materials.size(), "material",
           surface.name);
    const Material &material = scene.materials[static_cast<std::size_t>(surface.material)];
    expect((material.reflectance >= 0).all() && (material.reflectance < 1).all(), "reflectance", material.name);
    expect((material.exitance >= 0).all() && material.exitance.allFinite(), "exitance", material.name);
}

} // namespace

void expect_refusal_in_one_line(const std::function<void()> &read) {
    try {
        read();
    } catch (const BadInput &e) {
        expect_one_line(e.what());
    }
}

void expect_sound(const std::function<Scene()> &read) {
    expect_refusal_in_one_line([&] {
        const Scene scene = read();
        expect(!scene.surfaces.empty(), "no surface", scene.name);
        expect(std::isfinite(scene.own.size) && scene.own.size > 0 && scene.own.centre.allFinite(), "size", scene.name);
        for (const Surface &surface : scene.surfaces)
            expect_sound_surface(surface, scene);
        for (const std::string &note : scene.notes)
            expect_one_line(note);
    });
}

} // namespace penumbra::fuzz
