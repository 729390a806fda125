// A square of two patches on the left, one on the right: one hanging corner.
#include "render/mesh_sides.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

Snapshot three_patches() {
    Snapshot s;
    s.surfaces.push_back({Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(),
                          {Vec2(0, 0), Vec2(2, 0), Vec2(2, 2), Vec2(0, 2)}, {}, Rgb::Constant(0.5), Rgb::Zero(), "floor"});
    const auto add = [&](double x0, double y0, double x1, double y1, double value, SideKind right) {
        SnapshotPatch p;
        p.first = static_cast<std::int32_t>(s.coefficients.size());
        p.quad = {Vec2(x0, y0), {x1, y0}, {x1, y1}, {x0, y1}};
        p.corners = {p.quad.begin(), p.quad.end()};
        p.sides = {SideKind::uniform, right, SideKind::uniform, SideKind::uniform};
        s.coefficients.push_back(Rgb::Constant(value));
        s.patches.push_back(p);
    };
    add(0, 0, 1, 1, 1, SideKind::cut);
    add(0, 1, 1, 2, 2, SideKind::uniform);
    add(1, 0, 2, 2, 6, SideKind::uniform);
    s.patches[1].fresh = true;
    return s;
}

TEST(MeshSides, EachPieceOnce) {
    const MeshSides mesh = mesh_sides(three_patches());
    EXPECT_EQ(mesh.sides.size(), 10u); // 7 outer (the right patch has three whole ones), the middle in two, one across
    double length = 0;
    int cuts = 0, fresh = 0;
    for (const MeshSide &side : mesh.sides) {
        length += (side.to - side.from).norm();
        cuts += side.kind == SideKind::cut;
        fresh += side.fresh;
    }
    EXPECT_DOUBLE_EQ(length, 8 + 2 + 1);
    EXPECT_EQ(cuts, 1) << "the lower half of the middle line";
    EXPECT_EQ(fresh, 4) << "those of the upper left patch";
}

TEST(MeshSides, CornerValuesAreMeansOfWhatMeetsThere) {
    const MeshSides mesh = mesh_sides(three_patches());
    EXPECT_DOUBLE_EQ(mesh.corner_values[0][0][0], 1);
    EXPECT_DOUBLE_EQ(mesh.corner_values[0][1][0], (1 + 6) / 2.0);
    EXPECT_DOUBLE_EQ(mesh.corner_values[0][2][0], (1 + 2 + 6) / 3.0) << "the hanging corner: a side's patch counts, too";
    EXPECT_DOUBLE_EQ(mesh.corner_values[1][0][0], (1 + 2) / 2.0);
    EXPECT_DOUBLE_EQ(mesh.corner_values[2][1][0], 6);
}

} // namespace
} // namespace penumbra
