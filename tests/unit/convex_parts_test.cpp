// Concave polygons in convex parts, and these in quads and triangles.
#include "geometry/polygon.h"
#include "iteration/solver.h"
#include "unit/obj_text.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

/// A floor of 4 x 5 with a doorway of 0.9 x 0.2 in the middle of one side: two corners are in line with that side.
const Polygon floor_with_doorway{{0, 0}, {0.6, 0}, {0.6, -0.2}, {1.5, -0.2}, {1.5, 0}, {4, 0}, {4, 5}, {0, 5}};

void expect_true_corners(const Polygon &polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()], &c = polygon[(i + 2) % polygon.size()];
        EXPECT_GT(cross(b - a, c - b), 1e-3);
    }
}

TEST(ConvexParts, HaveNoCornersInLine) {
    double sum = 0;
    for (const Polygon &part : convex_parts(floor_with_doorway)) {
        sum += area(part);
        expect_true_corners(part);
        for (const Polygon &piece : quads_and_triangles(part))
            expect_true_corners(piece);
    }
    EXPECT_NEAR(sum, 4 * 5 + 0.9 * 0.2, 1e-14);
}

/// Such a floor, lit by a lamp of 1 W/m2, reflects at most half of that; a quad without area made it 10^9 times as
/// much.
TEST(ConvexParts, AFloorWithADoorwayIsLitAsAnyOther) {
    std::string obj = "mtllib m\nusemtl floor\n";
    for (const Vec2 &p : floor_with_doorway)
        obj += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " 0\n";
    obj += "f 1 2 3 4 5 6 7 8\nusemtl lamp\nv 1 1 1\nv 1 2 1\nv 2 2 1\nv 2 1 1\nf 9 10 11 12\n";
    const auto scene =
        std::make_shared<const Scene>(scene_of(obj, "newmtl floor\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0 0 0\nKe 1 1 1\n"));
    Solver solver(scene, Options{});
    EXPECT_TRUE(solver.run());
    EXPECT_GT(solver.snapshot()->peak, 0.05);
    EXPECT_LT(solver.snapshot()->peak, 0.5);
}

} // namespace
} // namespace penumbra
