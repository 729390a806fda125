// Complete and real curves on bundled scenes and on configurations that rooms are full of.
#include "completeness.h"
#include "random_rooms.h"

#include "scene/bundled.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace penumbra {
namespace {

/// The check itself must notice what it is there for.
TEST(Completeness, NoticesACurveThatIsMissing) {
    const Scene scene = open_scene("slanted-edge");
    CheckedPair pair(scene, SurfaceId(1), SurfaceId(0));
    ASSERT_FALSE(pair.curves().empty());
    pair.curves().pop_back();
    Tally tally;
    std::mt19937 random(1);
    pair.look_for_changes(20, random, tally);
    EXPECT_LT(tally.n_explained, 0.995 * tally.n_changes);
}

TEST(Completeness, NoticesACurveThatIsNotReal) {
    const Scene scene = open_scene("slanted-edge");
    CheckedPair pair(scene, SurfaceId(1), SurfaceId(0));
    ASSERT_FALSE(pair.curves().empty());
    pair.curves().front().to += Vec2(0.01, 0);
    Tally tally;
    pair.walk_curves(24, tally);
    EXPECT_LT(tally.real_length, 0.99 * tally.length);
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
    text.face(
        {{-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {-0.1, 0.5, 2.1}, {-0.1, -0.1, 2.1}, {0.5, -0.1, 2.25}, {0.5, -0.5, 2.25}},
        "lamp");
    text.face({{-0.4, -0.3, 1.1}, {0.55, -0.35, 1}, {0.6, 0.4, 1.08}, {0.1, -0.1, 1.06}, {-0.45, 0.5, 1.2}}, "black");
    expect_complete(check_scene(text.scene(), 40));
}

/// Edges in one plane whose ends no line of sight reaches: the shadow of the slit opens and closes in between.
TEST(Completeness, SlitBetweenParallelSlats) {
    ObjText text;
    text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
    text.face({{-0.4, -0.3, 2}, {-0.4, 0.5, 2}, {0.6, 0.5, 2}, {0.6, -0.3, 2}}, "lamp");
    text.face({{-1.5, -1.2, 1}, {1.5, -1.2, 1}, {1.5, 0.1, 1}, {-1.5, 0.1, 1}}, "black");
    text.face({{-1.5, 0.05, 1.2}, {1.5, 0.05, 1.2}, {1.5, 1.3, 1.2}, {-1.5, 1.3, 1.2}}, "black");
    expect_complete(check_scene(text.scene(), 40));
}

TEST(Completeness, SlitsAcrossATurnedLamp) {
    ObjText text;
    text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
    text.face({{-0.5, 0, 2}, {0.1, 0.5, 2.1}, {0.6, -0.1, 2.1}, {0, -0.6, 2}}, "lamp");
    for (int k = 0; k < 5; ++k) {
        const double y = -0.6 + 0.3 * k, z = 1 + 0.1 * (k % 2);
        text.face({{-1.2, y, z}, {1.2, y, z}, {1.2, y + 0.25, z + 0.1}, {-1.2, y + 0.25, z + 0.1}}, "black");
    }
    expect_complete(check_scene(text.scene(), 40));
}

/// Boxes that touch along edges, stand on each other askew, and overhang: edges that cross and faces in one plane.
TEST(Completeness, StackedAndTouchingBoxes) {
    ObjText text;
    text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
    text.face({{-0.4, -0.3, 2}, {-0.4, 0.5, 2}, {0.6, 0.5, 2}, {0.6, -0.3, 2}}, "lamp");
    const auto box = [&](const Vec3 &low, const Vec3 &high) {
        text.box((low + high) / 2, Eigen::Matrix3d((high - low).asDiagonal()) / 2, "black");
    };
    box({-0.5, -0.5, 0}, {0, 0, 0.5});
    box({0, -0.25, 0}, {0.5, 0.25, 0.5});       // touches the first along part of a face
    box({-0.25, -0.75, 0.5}, {0.25, 0.1, 0.8}); // on both, overhanging
    box({0.5, 0.25, 0}, {0.8, 0.6, 0.5});       // touches the second along an edge
    box({0.6, 0.1, 0.5}, {1, 0.4, 0.6});        // crosses its upper edges
    expect_complete(check_scene(text.scene(), 40));
}

/// Where two blockers' edges cross in space, every line of sight past the crossing is an event of its own.
TEST(Completeness, EdgesThatCross) {
    ObjText text;
    text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
    text.face({{-0.5, 0, 2}, {0.1, 0.5, 2.1}, {0.6, -0.1, 2.1}, {0, -0.6, 2}}, "lamp");
    text.face({{-0.5, 0, 1}, {0.5, 0, 1}, {0.5, 0.6, 1.1}, {-0.5, 0.6, 1.1}}, "black");
    text.face({{0, -0.5, 0.75}, {0, 0.5, 1.25}, {0.5, 0.6, 1.1}, {0.5, -0.4, 0.6}}, "black");
    expect_complete(check_scene(text.scene(), 60));
}

TEST(Completeness, BoxesOnAGrid) {
    Tally tally;
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        Random random(seed);
        const auto grid = [&](int low, int high) { return 0.25 * std::floor(random.in(low, high + 1)); };
        ObjText text;
        text.face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}}, "grey");
        text.face({{-0.25, -0.25, 2}, {-0.25, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.25, 2}}, "lamp");
        for (int k = 0; k < 3; ++k) {
            const Vec3 half(0.5 * grid(1, 3), 0.5 * grid(1, 3), 0.5 * grid(1, 2));
            const Vec3 low(grid(-4, 3), grid(-4, 3), grid(0, 3));
            text.box(low + half, half.asDiagonal(), "black");
        }
        tally += check_scene(text.scene(), 10, seed);
    }
    expect_complete(tally);
}

/// Three blockers' edges alone: none of them lies in the source's plane.
bool is_of_three_blocker_edges(const Scene &scene, const Curve &curve) {
    const PlaneFrame &source = scene.surface(curve.source).frame;
    return curve.kind == CurveKind::eee && std::ranges::none_of(curve.touched, [&](const TouchedEdge &edge) {
               return std::abs(source.height(edge.a)) < 1e-6 && std::abs(source.height(edge.b)) < 1e-6;
           });
}

/// The scene is there for what only three blockers' edges explain: without their curves it is not complete.
TEST(Completeness, ThreeBlockersNeedTheirThreeEdges) {
    const Scene scene = open_scene("three-blockers");
    CheckedPair pair(scene, SurfaceId(1), SurfaceId(0));
    std::erase_if(pair.curves(), [&](const Curve &c) { return is_of_three_blocker_edges(scene, c); });
    Tally tally;
    std::mt19937 random(1);
    pair.look_for_changes(20, random, tally);
    EXPECT_LT(tally.n_explained, 0.995 * tally.n_changes);
}

TEST(Completeness, SlantedEdge) { expect_complete(check_scene(open_scene("slanted-edge"), 20)); }
TEST(Completeness, Figure4) { expect_complete(check_scene(open_scene("figure-4"), 20)); }
TEST(Completeness, Stairs) { expect_complete(check_scene(open_scene("stairs"), 10)); }
TEST(Completeness, CornellBox) { expect_complete(check_scene(open_scene("cornell-box"), 8)); }
TEST(Completeness, SkewBlockers) { expect_complete(check_scene(open_scene("skew-blockers"), 20)); }
TEST(Completeness, Pierced) { expect_complete(check_scene(open_scene("pierced"), 10)); }
TEST(Completeness, ThreeBlockers) { expect_complete(check_scene(open_scene("three-blockers"), 20)); }
TEST(Completeness, NextRoom) { expect_complete(check_scene(open_scene("next-room"), 20)); }
TEST(Completeness, Table) { expect_complete(check_scene(open_scene("table"), 20)); }
/// The lamp of one room on its floor: among desk, chair and cabinet, with an open door.
TEST(Completeness, OfficeFloor) {
    const Scene scene = open_scene("office");
    const auto named = [&](const std::string &name) {
        return SurfaceId(
            static_cast<int>(std::ranges::find(scene.surfaces, name, &Surface::name) - scene.surfaces.begin()));
    };
    const CheckedPair pair(scene, named("light_1"), named("floor_1"));
    Tally tally;
    std::mt19937 random(1);
    pair.look_for_changes(6, random, tally);
    pair.walk_curves(6, tally);
    expect_complete(tally);
}

TEST(Completeness, VenetianBlinds) { expect_complete(check_scene(open_scene("venetian-blinds"), 40)); }
TEST(Completeness, BoxOnFloor) { expect_complete(check_scene(open_scene("box-on-floor"), 20)); }

} // namespace
} // namespace penumbra
