// Triangles back to polygons: whole where they can be, never with holes.
#include "scene/merge_triangles.h"

#include "geometry/plane_frame.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace penumbra {
namespace {

/// A grid of n x n unit squares in two triangles each, without the squares for which `is_hole`, in random order.
struct Grid {
    std::vector<Vec3> points;
    std::vector<MeshTriangle> triangles;

    template <class IsHole>
    Grid(int n, IsHole is_hole) {
        for (int y = 0; y <= n; ++y)
            for (int x = 0; x <= n; ++x)
                points.push_back(Vec3(x, y, 0));
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                if (is_hole(x, y))
                    continue;
                const int a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = a + n + 1;
                triangles.push_back({{a, b, c}});
                triangles.push_back({{a, c, d}});
            }
        std::ranges::shuffle(triangles, std::mt19937(7));
    }
};

double area_of(const MergedFace &face, const std::vector<Vec3> &points) {
    std::vector<Vec3> loop;
    for (const int c : face.corners)
        loop.push_back(points[static_cast<std::size_t>(c)]);
    return newell(loop).z() / 2;
}

double area_of(const std::vector<MergedFace> &faces, const std::vector<Vec3> &points) {
    double sum = 0;
    for (const MergedFace &face : faces)
        sum += area_of(face, points);
    return sum;
}

bool touches_itself(const MergedFace &face) {
    std::vector<int> corners = face.corners;
    std::ranges::sort(corners);
    return std::ranges::adjacent_find(corners) != corners.end();
}

TEST(MergeTriangles, AFloorOfManyIsOne) {
    const Grid floor(30, [](int, int) { return false; });
    const auto faces = merge_triangles(floor.points, floor.triangles);
    ASSERT_EQ(faces.size(), 1U);
    EXPECT_EQ(faces[0].corners.size(), 120U) << "corners of neighbours on its sides stay; build_scene drops them";
    EXPECT_EQ(area_of(faces, floor.points), 900);
}

TEST(MergeTriangles, AnLIsOneConcavePolygon) {
    const Grid l(8, [](int x, int y) { return x >= 3 && y >= 3; });
    const auto faces = merge_triangles(l.points, l.triangles);
    ASSERT_EQ(faces.size(), 1U);
    EXPECT_EQ(area_of(faces, l.points), 64 - 25);
}

TEST(MergeTriangles, AWallWithWindowsHasNoHoles) {
    const Grid wall(12, [](int x, int y) { return x % 4 == 1 && y % 3 == 1; });
    const auto faces = merge_triangles(wall.points, wall.triangles);
    EXPECT_GT(faces.size(), 1U);
    EXPECT_LT(faces.size(), 30U);
    EXPECT_EQ(area_of(faces, wall.points), 144 - 12);
    for (const MergedFace &face : faces)
        EXPECT_FALSE(touches_itself(face));
}

TEST(MergeTriangles, SquaresThatMeetAtACornerStayTwo) {
    const Grid two(2, [](int x, int y) { return x != y; });
    EXPECT_EQ(merge_triangles(two.points, two.triangles).size(), 2U);
}

TEST(MergeTriangles, MaterialsAndBendsDivide) {
    Grid square(1, [](int, int) { return false; });
    square.triangles[1].material = 1;
    EXPECT_EQ(merge_triangles(square.points, square.triangles).size(), 2U);
    square.triangles[1].material = 0;
    square.points[3].z() = 1e-5;
    EXPECT_EQ(merge_triangles(square.points, square.triangles).size(), 2U);
    square.points[3].z() = 1e-8; // the rounding of single precision
    EXPECT_EQ(merge_triangles(square.points, square.triangles).size(), 1U);
}

TEST(MergeTriangles, SlantedFloorsInSinglePrecisionAreOne) {
    Grid floor(20, [](int, int) { return false; });
    const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
    for (Vec3 &x : floor.points)
        x = (turn * x + Vec3(50, 0, 0)).cast<float>().cast<double>();
    EXPECT_EQ(merge_triangles(floor.points, floor.triangles).size(), 1U);
}

TEST(MergeTriangles, BacksAndDoubleEdgesAreKeptApart) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, -1, 0}};
    // The second is the first one's back; then three at one edge.
    EXPECT_EQ(merge_triangles(points, std::vector<MeshTriangle>{{{0, 1, 2}}, {{0, 2, 1}}}).size(), 2U);
    EXPECT_EQ(merge_triangles(points, std::vector<MeshTriangle>{{{0, 1, 2}}, {{1, 3, 2}}, {{1, 3, 2}}}).size(), 3U);
}

TEST(MergeTriangles, ASpiralThatOverlapsItselfStaysTriangles) {
    // A fan of 9 triangles of 50 degrees around one point, every spoke with a point of its own.
    std::vector<Vec3> points{Vec3::Zero()};
    std::vector<MeshTriangle> triangles;
    for (int i = 0; i <= 9; ++i) {
        const double a = i * 50 * M_PI / 180;
        points.push_back((1 + 0.1 * i) * Vec3(std::cos(a), std::sin(a), 0));
        if (i > 0)
            triangles.push_back({{0, i, i + 1}});
    }
    EXPECT_EQ(merge_triangles(points, triangles).size(), 9U);
}

TEST(MergeTriangles, TrianglesWithoutAreaStayAlone) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
    const auto faces = merge_triangles(points, std::vector<MeshTriangle>{{{0, 1, 3}}, {{1, 1, 2}}, {{0, 1, 2}}});
    ASSERT_EQ(faces.size(), 3U);
    EXPECT_EQ(faces[2].first, 2);
}

} // namespace
} // namespace penumbra
