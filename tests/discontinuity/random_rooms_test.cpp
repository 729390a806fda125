// Complete and real curves of one blocker, or one closed box, in random rooms.
#include "completeness.h"
#include "random_rooms.h"

#include "discontinuity/trace_curves.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace penumbra {
namespace {

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
                                      Eigen::AngleAxisd(random.in(-0.4, 0.4), Vec3::UnitX()))
                                         .toRotationMatrix();
        const Vec3 centre(-1.8, random.in(-0.2, 0.2), 0.1), u = 0.4 * turn.col(1), v = 0.5 * turn.col(2);
        text.face({centre - u - v, centre + u - v, centre + u + v, centre - u + v}, "lamp");
        add_box(text, random, random.in({-0.9, -0.4, 0.2}, {0.2, 0.4, 0.5}), true);
        tally += check_scene(text.scene(), 6, seed);
    }
    expect_complete(tally);
}

/// Up to six free polygons and three boxes, which pass through each other, the floor and the lamp's plane as they come.
/// PENUMBRA_RANDOM_SCENES in the environment asks for more of them than a quick run takes.
TEST(Completeness, ManyBlockers) {
    const char *asked = std::getenv("PENUMBRA_RANDOM_SCENES");
    const int n_scenes = asked ? std::atoi(asked) : 20;
    Tally tally;
    for (int seed = 0; seed < n_scenes; ++seed) {
        Random random(static_cast<std::uint32_t>(seed));
        ObjText text = turned_room(random);
        for (int i = 0; i < 1 + seed % 6; ++i)
            add_quad(text, random, random.in({-0.9, -0.9, 0.4}, {0.9, 0.9, 1.6}));
        for (int i = 0; i < seed % 4; ++i) {
            const Vec3 centre = random.in({-1, -1, 0.2}, {1, 1, 0.9});
            add_box(text, random, centre, random.in(0, 1) < 0.5);
        }
        tally += check_scene(text.scene(), 20);
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

/// Files often give six decimals: faces of a tilted box are then bent, and flattening them tears their shared edges.
TEST(Completeness, RoundedCoordinatesThrowTheSameCurves) {
    const auto curves_with = [](std::uint32_t seed, double unit) {
        Random random(seed);
        ObjText text = turned_room(random);
        const Vec3 centre = random.in({-0.7, -0.7, 0.7}, {0.7, 0.7, 1.2});
        Eigen::Matrix3d axes = random.turn();
        for (int k = 0; k < 3; ++k)
            axes.col(k) *= random.in(0.1, 0.4);
        text.box(centre, axes, "black", unit);
        return trace_emitter_curves(text.scene());
    };
    const auto length = [](const std::vector<Curve> &curves) {
        double sum = 0;
        for (const Curve &c : curves)
            if (c.kind != CurveKind::plane)
                sum += (c.to - c.from).norm();
        return sum;
    };
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        const auto exact = curves_with(seed, 0), rounded = curves_with(seed, 1e-6);
        EXPECT_EQ(rounded.size(), exact.size()) << seed;
        EXPECT_NEAR(length(rounded), length(exact), 1e-4) << seed;
    }
}

} // namespace
} // namespace penumbra
