// Coplanar overlap: who lies on top, and how much is covered. Areas are fractions worked out by hand.
#include "obj_text.h"

#include "scene/build_scene.h"
#include "visibility/ray_scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra {
namespace {

constexpr const char *materials = "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 1 1 1\n";
// A square of side 4 in z = 0 facing up, and corners of a square of side 2 about its middle.
const std::string large = "mtllib m\nv -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\n";
const std::string small = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

double covered(const Scene &scene, int s) {
    double sum = 0;
    for (const Polygon &p : scene.surface(SurfaceId(s)).covers)
        sum += area(p);
    return sum * scene.own.size * scene.own.size;
}

TEST(Covers, TheLaterLiesOnTop) {
    const Scene scene = scene_of(large + small + "usemtl grey\nf 1 2 3 4\nf 5 6 7 8\n", materials);
    EXPECT_NEAR(covered(scene, 0), 4, 1e-12);
    EXPECT_EQ(covered(scene, 1), 0);
}

TEST(Covers, TheEmitterLiesOnTopThoughItComesFirst) {
    const Scene scene = scene_of(large + small + "usemtl lamp\nf 5 6 7 8\nusemtl grey\nf 1 2 3 4\n", materials);
    EXPECT_EQ(covered(scene, 0), 0);
    EXPECT_NEAR(covered(scene, 1), 4, 1e-12);
}

TEST(Covers, FacingEachOthersWayBothAreCovered) {
    const Scene scene = scene_of(large + small + "f 1 2 3 4\nf 8 7 6 5\n", materials);
    EXPECT_NEAR(covered(scene, 0), 4, 1e-12);
    EXPECT_NEAR(covered(scene, 1), 4, 1e-12);
}

TEST(Covers, BackToBackIsADoubleSidedFaceAndCoversNothing) {
    // The same corners, begun at another one, and a lamp's back.
    for (const char *second : {"f 4 3 2 1\n", "f 2 1 4 3\n", "usemtl lamp\nf 3 2 1 4\n"}) {
        const Scene scene = scene_of(large + small + "usemtl grey\nf 1 2 3 4\n" + second, materials);
        EXPECT_EQ(covered(scene, 0), 0) << second;
        EXPECT_EQ(covered(scene, 1), 0) << second;
    }
}

TEST(Covers, PiecesLieInTheFrameOfTheCoveredOne) {
    const Scene scene = scene_of(large + "v 1 1 0\nv 5 1 0\nv 5 5 0\nv 1 5 0\nf 1 2 3 4\nf 5 6 7 8\n", materials);
    const Surface &below = scene.surface(SurfaceId(0));
    ASSERT_EQ(below.covers.size(), 1U);
    for (const Vec2 &p : below.covers[0]) {
        const Vec3 x = scene.own.to_own(below.frame.to_space(p));
        EXPECT_TRUE(x.x() > 1 - 1e-12 && x.x() < 2 + 1e-12 && x.y() > 1 - 1e-12 && x.y() < 2 + 1e-12) << x.transpose();
    }
    EXPECT_NEAR(covered(scene, 0), 1, 1e-12);
}

TEST(Covers, AConcaveCoverComesInConvexPieces) {
    // An L of area 3 of the middle square's 4.
    const Scene scene = scene_of(large + "v -1 -1 0\nv 1 -1 0\nv 1 0 0\nv 0 0 0\nv 0 1 0\nv -1 1 0\n"
                                         "f 1 2 3 4\nf 5 6 7 8 9 10\n",
                                 materials);
    EXPECT_NEAR(covered(scene, 0), 3, 1e-12);
    EXPECT_GE(scene.surface(SurfaceId(0)).covers.size(), 2U);
}

TEST(Covers, NeighboursThatShareAnEdgeDoNot) {
    const Scene scene = scene_of(large + "v 6 -2 0\nv 6 2 0\nf 1 2 3 4\nf 2 5 6 3\n", materials);
    EXPECT_EQ(covered(scene, 0) + covered(scene, 1), 0);
}

TEST(Covers, TurnedNeighboursThatShareAnEdgeDoNot) {
    // In a plane that no axis lies in, rounding moves the shared edge.
    const Scene scene = scene_of("v 0.1 0.2 0.7\nv 1.3 0.5 1.1\nv 0.9 1.6 0.3\nv 2.1 1.9 0.7\nf 1 2 3\nf 2 4 3\n");
    EXPECT_EQ(covered(scene, 0) + covered(scene, 1), 0);
}

TEST(Covers, AGapAboveTheToleranceIsNoContact) {
    const Scene near = scene_of(large + "v -1 -1 1e-8\nv 1 -1 1e-8\nv 1 1 1e-8\nv -1 1 1e-8\nf 1 2 3 4\nf 5 6 7 8\n");
    EXPECT_EQ(covered(near, 0), 0);
    const Scene touching =
        scene_of(large + "v -1 -1 1e-9\nv 1 -1 1e-9\nv 1 1 1e-9\nv -1 1 1e-9\nf 1 2 3 4\nf 5 6 7 8\n");
    EXPECT_NEAR(covered(touching, 0), 4, 1e-8);
}

TEST(Covers, TheSameFaceTwiceIsCoveredOnce) {
    const Scene scene = scene_of(large + "f 1 2 3 4\nf 1 2 3 4\n");
    EXPECT_NEAR(covered(scene, 0), 16, 1e-12);
    EXPECT_EQ(covered(scene, 1), 0);
}

TEST(Covers, RaysMeetWhatLiesOnTop) {
    // The large square reaches to 2, the small one on it to 1.
    for (const char *faces : {"usemtl lamp\nf 5 6 7 8\nusemtl grey\nf 1 2 3 4\n",
                              "usemtl grey\nf 1 2 3 4\nusemtl lamp\nf 5 6 7 8\n"}) {
        const Scene scene = scene_of(large + small + faces, materials);
        const RayScene rays(scene);
        const int lamp = scene.emits(SurfaceId(0)) ? 0 : 1;
        for (double x = -1.95; x < 2; x += 0.1)
            for (double y = -1.95; y < 2; y += 0.1) {
                const auto hit = rays.nearest(scene.own.to_solver({x, y, 1}), -Vec3::UnitZ());
                ASSERT_TRUE(hit && hit->front) << x << " " << y;
                EXPECT_EQ(hit->surface.index == lamp, std::abs(x) < 1 && std::abs(y) < 1) << x << " " << y;
            }
    }
}

TEST(Covers, TwoSidesOfOneFaceNeverDo) {
    RawScene raw;
    raw.materials.emplace_back();
    raw.faces.push_back({"sheet", "here", 0, true, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    const Scene scene = build_scene(raw);
    ASSERT_EQ(scene.n_surfaces(), 2);
    EXPECT_TRUE(scene.surfaces[1].back);
    EXPECT_LT(scene.surfaces[0].frame.normal.dot(scene.surfaces[1].frame.normal), -0.999);
    EXPECT_TRUE(scene.surfaces[0].covers.empty() && scene.surfaces[1].covers.empty());
}

} // namespace
} // namespace penumbra
