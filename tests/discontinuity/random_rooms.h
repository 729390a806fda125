// Rooms for the curves' tests: faces as OBJ text, with a seeded choice of places.
#pragma once

#include "unit/obj_text.h"

#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace penumbra {

using Corners = std::vector<Vec3>;

/// Faces as OBJ text, each with corners of its own.
class ObjText {
public:
    void face(const Corners &corners, const char *material) {
        faces_ += std::string("usemtl ") + material + "\nf";
        for (const Vec3 &c : corners) {
            std::ostringstream v;
            v.precision(17);
            v << "v " << c.x() << ' ' << c.y() << ' ' << c.z() << '\n';
            vertices_ += v.str();
            faces_ += ' ' + std::to_string(++n_);
        }
        faces_ += '\n';
    }
    /// A closed box with the given centre and half axes; seen from outside its corners run counter-clockwise.
    /// Coordinates are rounded to `unit`, unless it is 0.
    void box(const Vec3 &centre, const Eigen::Matrix3d &axes, const char *material, double unit = 0) {
        const auto rounded = [&](Corners corners) {
            for (Vec3 &c : corners)
                if (unit > 0)
                    c = (c.array() / unit).round() * unit;
            return corners;
        };
        for (int k = 0; k < 3; ++k)
            for (const double sign : {-1.0, 1.0}) {
                const Vec3 w = sign * axes.col(k), u = axes.col((k + 1) % 3), v = sign * axes.col((k + 2) % 3);
                face(rounded({centre + w - u - v, centre + w + u - v, centre + w + u + v, centre + w - u + v}),
                     material);
            }
    }
    Scene scene() const {
        return scene_of("mtllib m\n" + vertices_ + faces_,
                        "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl black\nKd 0 0 0\nnewmtl lamp\nKd 0 0 0\nKe 1 1 1\n");
    }

private:
    std::string vertices_, faces_;
    int n_ = 0;
};

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    Vec3 in(const Vec3 &low, const Vec3 &high) {
        const double x = in(low.x(), high.x()), y = in(low.y(), high.y()), z = in(low.z(), high.z());
        return {x, y, z};
    }
    Eigen::Matrix3d turn() {
        const Vec3 axis = in(Vec3::Constant(-1), Vec3::Constant(1)).normalized();
        return Eigen::AngleAxisd(in(0, 6.28), axis).toRotationMatrix();
    }

private:
    std::mt19937 engine_;
};

/// A floor under a light that is turned by up to 0.3 about a level axis, so that neither is aligned with the other.
inline ObjText turned_room(Random &random) {
    ObjText text;
    text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
    const Vec3 centre = random.in({-0.6, -0.6, 2}, {0.6, 0.6, 2.4});
    const double angle = random.in(0, 6.28);
    const Eigen::Matrix3d turn = (Eigen::AngleAxisd(random.in(-0.3, 0.3), Vec3(std::cos(angle), std::sin(angle), 0)) *
                                  Eigen::AngleAxisd(random.in(0, 6.28), Vec3::UnitZ()))
                                     .toRotationMatrix();
    const Vec3 u = random.in(0.2, 0.6) * turn.col(0), v = random.in(0.2, 0.6) * turn.col(1);
    text.face({centre - u - v, centre - u + v, centre + u + v, centre + u - v}, "lamp");
    return text;
}

inline void add_quad(ObjText &text, Random &random, const Vec3 &centre) {
    const Eigen::Matrix3d turn = random.turn();
    const Vec3 u = random.in(0.1, 0.6) * turn.col(0), v = random.in(0.1, 0.6) * turn.col(1);
    text.face({centre - u - v, centre + u - v, centre + u + 1.3 * v, centre - u + 0.8 * v}, "black");
}

inline void add_box(ObjText &text, Random &random, const Vec3 &centre, bool upright) {
    Eigen::Matrix3d axes =
        upright ? Eigen::AngleAxisd(random.in(0, 6.28), Vec3::UnitZ()).toRotationMatrix() : random.turn();
    for (int k = 0; k < 3; ++k)
        axes.col(k) *= k == 2 && upright ? centre.z() : random.in(0.1, 0.4);
    text.box(centre, axes, "black");
}

} // namespace penumbra
