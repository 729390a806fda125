#include "office/office.h"

#include "core/vec.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numbers>
#include <span>
#include <vector>

namespace penumbra {

namespace {

constexpr double wide = 4, deep = 5, high = 2.7, wall = 0.2;
constexpr double corridor = 1.6; ///< its width
constexpr double door_wide = 0.9, door_high = 2.1;
constexpr double pitch = wide + wall;
constexpr int room_polygons = 76, corridor_polygons = 6;

constexpr const char *materials = R"(newmtl carpet
Kd 0.35 0.33 0.3

newmtl plaster
Kd 0.75 0.74 0.7

newmtl wood
Kd 0.55 0.4 0.25

newmtl cloth
Kd 0.2 0.3 0.5

newmtl steel
Kd 0.5 0.52 0.55

newmtl screen
Kd 0.05 0.05 0.06

newmtl lamp
Kd 0.7 0.7 0.7
Ke 30 29 26
)";

/// From a room's own coordinates, in which the corridor is towards -y, to the building's: rooms of odd number stand on
/// the other side of the corridor, as in a mirror.
struct Room {
    int number;

    bool mirrored() const { return number % 2 == 1; }
    double x() const { return pitch * (number / 2); }
    double door() const { return number % 4 < 2 ? 0.6 : 2.5; }
    Vec3 place(const Vec3 &p) const {
        const double y = corridor / 2 + wall + p.y();
        return {x() + p.x(), mirrored() ? -y : y, p.z()};
    }
};

class ObjWriter {
public:
    void object(const std::string &name, const char *material) {
        fmt::format_to(std::back_inserter(text_), "\no {}\nusemtl {}\n", name, material);
    }
    void face(const std::vector<Vec3> &corners) {
        vertices(corners);
        std::vector<int> all(corners.size());
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<int>(i);
        polygon(all);
        n_ += static_cast<int>(corners.size());
    }
    /// An upright closed box on the given counter-clockwise base.
    void box(const std::vector<Vec3> &base, double height) {
        std::vector<Vec3> corners = base;
        for (const Vec3 &c : base)
            corners.push_back(c + height * Vec3::UnitZ());
        vertices(corners);
        for (const std::vector<int> &side : std::vector<std::vector<int>>{
                 {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}})
            polygon(side);
        n_ += 8;
    }
    std::string take() { return std::move(text_); }

private:
    /// Rounded to 0.1 mm; upright boxes stay planar.
    void vertices(const std::vector<Vec3> &corners) {
        for (const Vec3 &c : corners) {
            text_ += 'v';
            for (const double x : c)
                fmt::format_to(std::back_inserter(text_), " {}", std::round(1e4 * x) / 1e4 + 0.0);
            text_ += '\n';
        }
    }
    void polygon(std::span<const int> corners) {
        text_ += 'f';
        for (const int c : corners)
            fmt::format_to(std::back_inserter(text_), " {}", n_ + c + 1);
        text_ += '\n';
    }

    std::string text_;
    int n_ = 0;
};

class RoomWriter {
public:
    RoomWriter(ObjWriter &obj, const Room &room) : obj_(obj), room_(room) {}

    void write() {
        shell();
        desk();
        chair();
        object("cabinet", "steel");
        box({0, 1.4, 0}, {0.45, 2.6, 1.8});
        object("screen", "screen");
        box({1.7, 3.9, 0.74}, {2.3, 3.96, 1.14});
    }

private:
    void object(const char *name, const char *material) {
        obj_.object(fmt::format("{}_{}", name, room_.number + 1), material);
    }
    std::vector<Vec3> placed(std::vector<Vec3> corners) const {
        for (Vec3 &c : corners)
            c = room_.place(c);
        if (room_.mirrored())
            std::ranges::reverse(corners);
        return corners;
    }
    void face(const std::vector<Vec3> &corners) { obj_.face(placed(corners)); }
    void box(const Vec3 &low, const Vec3 &top) {
        const double z = low.z();
        obj_.box(placed({{low.x(), low.y(), z}, {top.x(), low.y(), z}, {top.x(), top.y(), z}, {low.x(), top.y(), z}}),
                 top.z() - z);
    }

    void shell() {
        const double a = room_.door(), b = a + door_wide, h = door_high, w = wide, d = deep, t = high;
        object("floor", "carpet");
        face({{0, 0, 0}, {a, 0, 0}, {a, -wall, 0}, {b, -wall, 0}, {b, 0, 0}, {w, 0, 0}, {w, d, 0}, {0, d, 0}});
        object("light", "lamp");
        face({{1.4, 2.2, t}, {1.4, 2.8, t}, {2.6, 2.8, t}, {2.6, 2.2, t}});
        object("ceiling", "plaster");
        face({{0, 0, t}, {0, d, t}, {w, d, t}, {w, 0, t}});
        object("walls", "plaster");
        face({{0, d, 0}, {0, d, t}, {0, 0, t}, {0, 0, 0}});
        face({{w, 0, 0}, {w, 0, t}, {w, d, t}, {w, d, 0}});
        face({{w, d, 0}, {w, d, t}, {0, d, t}, {0, d, 0}});
        face({{0, 0, 0}, {0, 0, t}, {w, 0, t}, {w, 0, 0}, {b, 0, 0}, {b, 0, h}, {a, 0, h}, {a, 0, 0}});
        object("door", "plaster");
        face({{a, -wall, 0}, {a, 0, 0}, {a, 0, h}, {a, -wall, h}});
        face({{b, 0, 0}, {b, -wall, 0}, {b, -wall, h}, {b, 0, h}});
        face({{a, -wall, h}, {a, 0, h}, {b, 0, h}, {b, -wall, h}});
    }
    void desk() {
        object("desk", "wood");
        box({1.2, 3.4, 0.7}, {2.8, 4.2, 0.74});
        for (const double x : {1.25, 2.7})
            for (const double y : {3.45, 4.1})
                box({x, y, 0}, {x + 0.05, y + 0.05, 0.7});
    }
    void chair() {
        object("chair", "cloth");
        turned_box(0.22, -0.22, 0.22, 0, 0.04);
        turned_box(0.04, -0.04, 0.04, 0.04, 0.38);
        turned_box(0.24, -0.24, 0.24, 0.42, 0.06);
        turned_box(0.2, -0.22, -0.17, 0.48, 0.5);
    }
    /// A box from -half to half and from `back` to `front`, turned about the chair's own axis.
    void turned_box(double half, double back, double front, double z, double height) {
        const double angle = (25 + 40 * room_.number) * std::numbers::pi / 180;
        const Vec3 u(std::cos(angle), std::sin(angle), 0), v(-u.y(), u.x(), 0), centre(2, 2.9, z);
        obj_.box(placed({centre - half * u + back * v, centre + half * u + back * v, centre + half * u + front * v,
                         centre - half * u + front * v}),
                 height);
    }

    ObjWriter &obj_;
    const Room &room_;
};

void write_corridor(ObjWriter &obj, int n_rooms) {
    const double c = corridor / 2, length = pitch * ((n_rooms + 1) / 2) - wall;
    obj.object("corridor_floor", "carpet");
    obj.face({{0, -c, 0}, {length, -c, 0}, {length, c, 0}, {0, c, 0}});
    obj.object("corridor_ceiling", "plaster");
    obj.face({{0, -c, high}, {0, c, high}, {length, c, high}, {length, -c, high}});
    obj.object("corridor_walls", "plaster");
    obj.face({{0, c, 0}, {0, c, high}, {0, -c, high}, {0, -c, 0}});
    obj.face({{length, -c, 0}, {length, -c, high}, {length, c, high}, {length, c, 0}});
    for (const bool mirrored : {false, true}) {
        const double y = mirrored ? -c : c;
        std::vector<Vec3> corners{{length, y, 0}, {length, y, high}, {0, y, high}, {0, y, 0}};
        for (int k = mirrored; k < n_rooms; k += 2) {
            const Room room{k};
            const double a = room.x() + room.door(), b = a + door_wide;
            corners.insert(corners.end(), {{a, y, 0}, {a, y, door_high}, {b, y, door_high}, {b, y, 0}});
        }
        if (mirrored)
            std::ranges::reverse(corners);
        obj.face(corners);
    }
}

} // namespace

SceneText office(int n_polygons, const std::string &name) {
    const int n_rooms =
        std::max(1, static_cast<int>(std::lround((n_polygons - corridor_polygons) / double(room_polygons))));
    const double length = pitch * ((n_rooms + 1) / 2) - wall, away = std::max(0.55 * length, 8.0);
    ObjWriter obj;
    write_corridor(obj, n_rooms);
    for (int k = 0; k < n_rooms; ++k)
        RoomWriter(obj, Room{k}).write();
    const std::string rooms = n_rooms == 1 ? "One office" : fmt::format("{} offices", n_rooms);
    return {
        fmt::format("# penumbra: {} on a corridor: each lit by its own lamp, the corridor through the doors\n"
                    "# view: {:.4g} {:.4g} {:.4g} {:.4g} -1 0 38\n"
                    "# Units are metres, z is up. Made by make_office; ceilings and outer walls show their backs from\n"
                    "# outside and are not drawn.\n"
                    "mtllib {}.mtl\n",
                    rooms, length / 2 + 0.15 * away, -1.75 * away, 1.4 * away, length / 2, name) +
            obj.take(),
        materials};
}

} // namespace penumbra
