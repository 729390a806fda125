#include "stability/random_scenes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {

namespace {

using reference::Face;

/// Plain arithmetic on the engine's numbers: distributions differ between libraries.
class Draw {
public:
    explicit Draw(std::uint32_t seed) : engine_(seed) { engine_.discard(20); }
    double in(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }
    int below(int n) { return static_cast<int>(in(0, n)); }
    Rgb reflectance() { return one_in(8) ? Rgb(Rgb::Zero()) : Rgb(in(0.05, 0.9), in(0.05, 0.9), in(0.05, 0.9)); }
    Rgb exitance() { return {in(0.5, 2), in(0.5, 2), in(0.5, 2)}; }
    bool one_in(int n) { return below(n) == 0; }
    Vec3 direction() {
        const double z = in(-1, 1), angle = in(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

private:
    std::mt19937 engine_;
};

struct Room {
    double wide, deep, high;
};

void add(std::vector<Face> &faces, Draw &draw, const Vec3 &corner, const Vec3 &a, const Vec3 &b) {
    faces.push_back({{corner, corner + a, corner + a + b, corner + b}, draw.reflectance()});
}

void add_walls(std::vector<Face> &faces, Draw &draw, const Room &room) {
    const Vec3 x = room.wide * Vec3::UnitX(), y = room.deep * Vec3::UnitY(), z = room.high * Vec3::UnitZ(),
               o = Vec3::Zero();
    add(faces, draw, o, x, y);
    const int kind = draw.below(3);
    if (kind == 0)
        return;
    add(faces, draw, o, z, x);
    if (kind == 1 && draw.one_in(2))
        add(faces, draw, o, y, z);
    if (kind == 2) {
        add(faces, draw, o, y, z);
        add(faces, draw, y, x, z);
        add(faces, draw, x, z, y);
        add(faces, draw, z, y, x);
    }
}

/// A lamp that looks down; in the plane of the ceiling, or below it.
void add_lamp(std::vector<Face> &faces, Draw &draw, const Room &room) {
    const double wide = room.wide * draw.in(0.1, 0.4), deep = room.deep * draw.in(0.1, 0.4);
    const double x = draw.in(0.05, 0.95) * (room.wide - wide), y = draw.in(0.05, 0.95) * (room.deep - deep);
    const double z = room.high * (draw.one_in(2) ? 1.0 : draw.in(0.7, 0.98));
    Face lamp{{{x, y, z}, {x, y + deep, z}, {x + wide, y + deep, z}, {x + wide, y, z}}};
    lamp.reflectance = draw.one_in(2) ? Rgb(Rgb::Zero()) : draw.reflectance();
    lamp.exitance = draw.exitance();
    faces.push_back(lamp);
}

/// Three to six corners about a centre inside the room, in any plane; `slim`: width over length.
void add_polygon(std::vector<Face> &faces, Draw &draw, const Room &room, double slim) {
    const Vec3 centre(room.wide * draw.in(0.3, 0.7), room.deep * draw.in(0.3, 0.7), room.high * draw.in(0.3, 0.6));
    const double most = 0.28 * std::min({room.wide, room.deep, room.high});
    const Vec3 n = draw.direction(), u = n.unitOrthogonal(), v = n.cross(u);
    const int corners = 3 + draw.below(4);
    const double from = draw.in(0, 6.28), reach = most * draw.in(0.4, 1);
    Face face{{}, draw.reflectance()};
    for (int k = 0; k < corners; ++k) {
        const double angle = from + 2 * std::numbers::pi * (k + draw.in(-0.3, 0.3)) / corners;
        face.corners.push_back(centre + reach * (std::cos(angle) * u + slim * std::sin(angle) * v));
    }
    if (draw.one_in(6))
        face.exitance = draw.exitance();
    faces.push_back(face);
}

void add_box(std::vector<Face> &faces, Draw &draw, const Room &room) {
    const double least = std::min(room.wide, room.deep);
    const double a = least * draw.in(0.08, 0.25), b = least * draw.in(0.08, 0.25), c = room.high * draw.in(0.1, 0.35);
    const double angle = draw.one_in(3) ? 0 : draw.in(0, 1.57);
    const Vec3 u(std::cos(angle), std::sin(angle), 0), v(-std::sin(angle), std::cos(angle), 0);
    const Vec3 corner(room.wide * draw.in(0.3, 0.65), room.deep * draw.in(0.05, 0.65),
                      draw.one_in(2) ? 0 : room.high * draw.in(0.05, 0.3));
    auto box = reference::box(corner, a * u, b * v, c * Vec3::UnitZ(), draw.reflectance());
    faces.insert(faces.end(), box.begin(), box.end());
}

/// A sheet on the floor: it covers what is below it.
void add_sheet(std::vector<Face> &faces, Draw &draw, const Room &room) {
    const double angle = draw.in(0, 1.57), half = 0.2 * std::min(room.wide, room.deep) * draw.in(0.3, 1);
    const Vec3 centre(room.wide / 2, room.deep / 2, 0), u(half * std::cos(angle), half * std::sin(angle), 0),
        v(-u.y(), u.x(), 0);
    faces.push_back({{centre - u - v, centre + u - v, centre + u + v, centre - u + v}, draw.reflectance()});
}

} // namespace

RandomScene random_scene(std::uint32_t seed) {
    Draw draw(seed);
    RandomScene scene;
    scene.options.threshold = draw.one_in(2) ? 0.05 : 0.02;
    scene.options.strategy = all_strategies[draw.below(4)];
    scene.options.order = 2 + draw.below(3);
    const Room room{draw.in(0.5, 2), draw.in(0.5, 2), draw.in(0.5, 1.5)};
    add_walls(scene.faces, draw, room);
    for (int n = draw.one_in(3) ? 2 : 1; n > 0; --n)
        add_lamp(scene.faces, draw, room);
    for (int n = draw.below(4); n > 0; --n)
        switch (draw.below(5)) {
        case 0:
        case 1:
            add_polygon(scene.faces, draw, room, draw.in(0.4, 1));
            break;
        case 2:
            add_polygon(scene.faces, draw, room, std::pow(10, -draw.in(1, 4)));
            break;
        case 3:
            add_box(scene.faces, draw, room);
            break;
        default:
            add_sheet(scene.faces, draw, room);
        }
    return scene;
}

} // namespace penumbra
