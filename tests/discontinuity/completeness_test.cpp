// Curves against changes of the visible part's shape, both ways (see visible_shape.h).
#include "visible_shape.h"

#include "discontinuity/trace_curves.h"
#include "scene/bundled.h"
#include "unit/obj_text.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace penumbra {
namespace {

struct Tally {
    int n_changes = 0, n_explained = 0;
    double length = 0, real_length = 0;
    std::string first_unexplained, first_unreal;

    Tally &operator+=(const Tally &o) {
        n_changes += o.n_changes;
        n_explained += o.n_explained;
        length += o.length;
        real_length += o.real_length;
        if (first_unexplained.empty())
            first_unexplained = o.first_unexplained;
        if (first_unreal.empty())
            first_unreal = o.first_unreal;
        return *this;
    }
};

double distance(const Curve &c, const Vec2 &p) {
    const Vec2 d = c.to - c.from;
    const double t = std::clamp((p - c.from).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (c.from + t * d - p).norm();
}

std::string text(const VisibleShape &shape) {
    std::string all = "{";
    for (const std::string &corner : shape)
        all += corner + ", ";
    return all + "}";
}

class Pair {
public:
    Pair(const Scene &scene, SurfaceId source, SurfaceId receiver)
        : scene_(scene), receiver_(receiver), reader_(scene, source, receiver),
          curves_(trace_curves(scene, source, receiver, possible_blockers(scene, source, receiver))),
          size_(2 * radius(scene.surface(receiver).outline)) {}

    /// Every change of the shape along random segments must lie within 1e-5 of a curve.
    void look_for_changes(int n_segments, std::mt19937 &random, Tally &tally) const {
        const Polygon &outline = scene_.surface(receiver_).outline;
        const auto point = [&] { return random_point(outline, random); };
        for (int i = 0; i < n_segments; ++i) {
            const Vec2 a = point(), b = point();
            constexpr int n_steps = 60;
            VisibleShape before = reader_.at(a);
            for (int k = 0; k < n_steps; ++k) {
                const double t = k / double(n_steps), u = (k + 1) / double(n_steps);
                VisibleShape after = reader_.at(a + u * (b - a));
                bisect(a, b, t, u, before, after, tally);
                before = std::move(after);
            }
        }
    }

    /// Of the curves' length, the part with different shapes on its two sides.
    void walk_curves(int n_per_curve, Tally &tally) const {
        for (const Curve &c : curves_) {
            if (c.kind == CurveKind::plane)
                continue;
            const Vec2 along = c.to - c.from, across = Vec2(-along.y(), along.x()).normalized();
            for (int k = 0; k < n_per_curve; ++k) {
                const Vec2 x = c.from + (k + 0.5) / n_per_curve * along;
                tally.length += along.norm() / n_per_curve;
                const VisibleShape left = reader_.at(x + 1e-6 * across), right = reader_.at(x - 1e-6 * across);
                if (left != right)
                    tally.real_length += along.norm() / n_per_curve;
                else if (tally.first_unreal.empty())
                    tally.first_unreal = std::string(name(c.kind)) + " at " + where(x) + " sees " + text(left);
            }
        }
    }

    const std::vector<Curve> &curves() const { return curves_; }

private:
    static Vec2 random_point(const Polygon &outline, std::mt19937 &random) {
        Vec2 low = outline[0], high = outline[0];
        for (const Vec2 &p : outline) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        std::uniform_real_distribution<double> unit;
        const double u = unit(random), v = unit(random);
        return low + Vec2(u * (high - low).x(), v * (high - low).y());
    }
    std::string where(const Vec2 &x) const {
        const Vec3 own = scene_.own.to_own(scene_.surface(receiver_).frame.to_space(x));
        return std::to_string(own.x()) + " " + std::to_string(own.y()) + " " + std::to_string(own.z());
    }
    void bisect(const Vec2 &a, const Vec2 &b, double t, double u, const VisibleShape &before, const VisibleShape &after,
                Tally &tally) const {
        if (before == after)
            return;
        if ((u - t) * (b - a).norm() < 1e-6 * size_) {
            const Vec2 x = a + (t + u) / 2 * (b - a);
            if (!reader_.on_receiver(a + t * (b - a)) || !reader_.on_receiver(a + u * (b - a)))
                return; // the receiver's own border
            ++tally.n_changes;
            if (std::ranges::any_of(curves_, [&](const Curve &c) { return distance(c, x) <= 1e-5 * size_; }))
                ++tally.n_explained;
            else if (tally.first_unexplained.empty())
                tally.first_unexplained = where(x) + ": " + text(before) + " to " + text(after);
            return;
        }
        const double middle = (t + u) / 2;
        const VisibleShape between = reader_.at(a + middle * (b - a));
        bisect(a, b, t, middle, before, between, tally);
        bisect(a, b, middle, u, between, after, tally);
    }

    const Scene &scene_;
    SurfaceId receiver_;
    ShapeReader reader_;
    std::vector<Curve> curves_;
    double size_;
};

Tally check_scene(const Scene &scene, int n_segments, std::uint32_t seed = 1) {
    Tally tally;
    std::mt19937 random(seed);
    for (int r = 0; r < scene.n_surfaces(); ++r)
        for (int s = 0; s < scene.n_surfaces(); ++s)
            if (r != s && scene.emits(SurfaceId(s)) && scene.reflects(SurfaceId(r))) {
                const Pair pair(scene, SurfaceId(s), SurfaceId(r));
                pair.look_for_changes(n_segments, random, tally);
                pair.walk_curves(24, tally);
            }
    return tally;
}

void expect_complete(const Tally &tally) {
    std::printf("%d of %d changes on a curve; change across %.4f of %.4f\n", tally.n_explained, tally.n_changes,
                tally.real_length, tally.length);
    EXPECT_GT(tally.n_changes, 0);
    if (!tally.first_unexplained.empty())
        std::printf("first unexplained: %s\n", tally.first_unexplained.c_str());
    EXPECT_GE(tally.n_explained, 0.995 * tally.n_changes) << tally.first_unexplained;
    EXPECT_GT(tally.length, 0);
    EXPECT_GE(tally.real_length, 0.99 * tally.length) << tally.first_unreal;
}

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
    void box(const Vec3 &centre, const Eigen::Matrix3d &axes, const char *material) {
        for (int k = 0; k < 3; ++k)
            for (const double sign : {-1.0, 1.0}) {
                const Vec3 w = sign * axes.col(k), u = axes.col((k + 1) % 3), v = sign * axes.col((k + 2) % 3);
                face({centre + w - u - v, centre + w + u - v, centre + w + u + v, centre + w - u + v}, material);
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
ObjText turned_room(Random &random) {
    ObjText text;
    text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
    const Vec3 centre = random.in({-0.6, -0.6, 2}, {0.6, 0.6, 2.4});
    const double angle = random.in(0, 6.28);
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(random.in(-0.3, 0.3), Vec3(std::cos(angle), std::sin(angle), 0)) *
         Eigen::AngleAxisd(random.in(0, 6.28), Vec3::UnitZ())).toRotationMatrix();
    const Vec3 u = random.in(0.2, 0.6) * turn.col(0), v = random.in(0.2, 0.6) * turn.col(1);
    text.face({centre - u - v, centre - u + v, centre + u + v, centre + u - v}, "lamp");
    return text;
}

void add_quad(ObjText &text, Random &random, const Vec3 &centre) {
    const Eigen::Matrix3d turn = random.turn();
    const Vec3 u = random.in(0.1, 0.6) * turn.col(0), v = random.in(0.1, 0.6) * turn.col(1);
    text.face({centre - u - v, centre + u - v, centre + u + 1.3 * v, centre - u + 0.8 * v}, "black");
}

void add_box(ObjText &text, Random &random, const Vec3 &centre, bool upright) {
    Eigen::Matrix3d axes = upright ? Eigen::AngleAxisd(random.in(0, 6.28), Vec3::UnitZ()).toRotationMatrix()
                                   : random.turn();
    for (int k = 0; k < 3; ++k)
        axes.col(k) *= k == 2 && upright ? centre.z() : random.in(0.1, 0.4);
    text.box(centre, axes, "black");
}

TEST(Completeness, OneFreeQuad) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        ObjText text = turned_room(random);
        add_quad(text, random, random.in({-0.7, -0.7, 0.9}, {0.7, 0.7, 1.3}));
        tally += check_scene(text.scene(), 6, seed);
    }
    expect_complete(tally);
}

TEST(Completeness, OneQuadThroughTheFloor) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        ObjText text = turned_room(random);
        add_quad(text, random, random.in({-1, -1, 0}, {1, 1, 0.2}));
        tally += check_scene(text.scene(), 6, seed);
    }
    expect_complete(tally);
}

TEST(Completeness, OneQuadThroughTheLightsPlane) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        ObjText text = turned_room(random);
        add_quad(text, random, random.in({-0.7, -0.7, 1.9}, {0.7, 0.7, 2.2}));
        tally += check_scene(text.scene(), 6, seed);
    }
    expect_complete(tally);
}

TEST(Completeness, OneFreeBox) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        ObjText text = turned_room(random);
        add_box(text, random, random.in({-0.7, -0.7, 0.7}, {0.7, 0.7, 1.2}), false);
        tally += check_scene(text.scene(), 6, seed);
    }
    expect_complete(tally);
}

TEST(Completeness, OneStandingBox) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        ObjText text = turned_room(random);
        add_box(text, random, random.in({-0.9, -0.9, 0.2}, {0.9, 0.9, 0.5}), true);
        tally += check_scene(text.scene(), 6, seed);
    }
    expect_complete(tally);
}

TEST(Completeness, OneBoxThroughTheFloor) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        ObjText text = turned_room(random);
        add_box(text, random, random.in({-0.9, -0.9, 0}, {0.9, 0.9, 0.2}), false);
        tally += check_scene(text.scene(), 6, seed);
    }
    expect_complete(tally);
}

/// An upright light that sinks into the floor beside a box that stands there: the horizon cuts the light.
TEST(Completeness, LightThroughTheFloorAndABox) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        ObjText text;
        text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
        const Eigen::Matrix3d turn = (Eigen::AngleAxisd(random.in(-0.5, 0.5), Vec3::UnitY()) *
                                      Eigen::AngleAxisd(random.in(-0.4, 0.4), Vec3::UnitX())).toRotationMatrix();
        const Vec3 centre(-1.8, random.in(-0.2, 0.2), 0.1), u = 0.4 * turn.col(1), v = 0.5 * turn.col(2);
        text.face({centre - u - v, centre + u - v, centre + u + v, centre - u + v}, "lamp");
        add_box(text, random, random.in({-0.9, -0.4, 0.2}, {0.2, 0.4, 0.5}), true);
        tally += check_scene(text.scene(), 6, seed);
    }
    expect_complete(tally);
}

/// Corners on a coarse grid: edges parallel to the light's, faces in line with its corners and with each other.
TEST(Completeness, OneBoxOnAGrid) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        const auto grid = [&](int low, int high) { return 0.25 * std::floor(random.in(low, high + 1)); };
        ObjText text;
        text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
        const double x = grid(-3, 1), y = grid(-3, 1), w = grid(1, 3), d = grid(1, 3);
        text.face({{x, y, 2}, {x, y + d, 2}, {x + w, y + d, 2}, {x + w, y, 2}}, "lamp");
        const Vec3 half(0.5 * grid(1, 3), 0.5 * grid(1, 3), 0.5 * grid(1, 3));
        const Vec3 low(grid(-4, 3), grid(-4, 3), grid(0, 2));
        text.box(low + half, half.asDiagonal(), "black");
        tally += check_scene(text.scene(), 6, seed);
    }
    expect_complete(tally);
}

/// A lamp at the top of a shaft in the ceiling: walls hang from all its edges.
TEST(Completeness, RecessedLamp) {
    ObjText text;
    text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
    const Corners lamp{{-0.4, -0.3, 2}, {-0.4, 0.5, 2}, {0.6, 0.4, 2}, {0.5, -0.5, 2}};
    text.face(lamp, "lamp");
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 a = lamp[i], b = lamp[(i + 1) % 4], down(0, 0, -0.5);
        text.face({a, b, b + down, a + down}, "black");
    }
    expect_complete(check_scene(text.scene(), 40));
}

/// The lamp hangs in the middle of a ceiling, in its plane, and a wall hangs from the ceiling through the lamp.
TEST(Completeness, LampInACeilingAndAWallThatHangsAcrossIt) {
    ObjText text;
    text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
    text.face({{-2, -2, 2}, {-2, 2, 2}, {2, 2, 2}, {2, -2, 2}}, "grey");
    text.face({{-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}}, "lamp");
    text.face({{0.2, -0.3, 2}, {0.1, 0.8, 2}, {0.1, 0.8, 1.5}, {0.2, -0.3, 1.5}}, "black");
    expect_complete(check_scene(text.scene(), 40));
}

TEST(Completeness, ConcaveLampAndConcaveBlocker) {
    ObjText text;
    text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
    text.face({{-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {-0.1, 0.5, 2.1}, {-0.1, -0.1, 2.1}, {0.5, -0.1, 2.25}, {0.5, -0.5, 2.25}},
              "lamp");
    text.face({{-0.4, -0.3, 1.1}, {0.55, -0.35, 1}, {0.6, 0.4, 1.08}, {0.1, -0.1, 1.06}, {-0.45, 0.5, 1.2}}, "black");
    expect_complete(check_scene(text.scene(), 40));
}

TEST(Completeness, SlantedEdge) { expect_complete(check_scene(open_scene("slanted-edge"), 20)); }
TEST(Completeness, Figure4) { expect_complete(check_scene(open_scene("figure-4"), 20)); }
TEST(Completeness, Stairs) { expect_complete(check_scene(open_scene("stairs"), 10)); }
TEST(Completeness, CornellBox) { expect_complete(check_scene(open_scene("cornell-box"), 8)); }
TEST(Completeness, BoxOnFloor) { expect_complete(check_scene(open_scene("box-on-floor"), 20)); }

} // namespace
} // namespace penumbra
