// Curves at places worked out by hand.
#include "discontinuity/trace_curves.h"
#include "scene/bundled.h"
#include "unit/obj_text.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace penumbra {
namespace {

constexpr const char *materials =
    "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl black\nKd 0 0 0\nnewmtl lamp\nKd 0 0 0\nKe 1 1 1\n";
/// A floor 4x4 at z = 0 and a light 1x1 at z = 2 that faces it.
const std::string room =
    "mtllib m\nv -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nusemtl grey\nf 1 2 3 4\n"
    "v -0.5 -0.5 2\nv -0.5 0.5 2\nv 0.5 0.5 2\nv 0.5 -0.5 2\nusemtl lamp\nf 5 6 7 8\nusemtl black\n";
constexpr double accuracy = 1e-12;

struct Line {
    CurveKind kind;
    int order;
    Vec3 from, to; ///< in the scene's own frame
    std::vector<SurfaceId> blockers;
};

std::vector<Line> curves_of(const Scene &scene, int receiver = 0) {
    std::vector<Line> lines;
    for (const Curve &c : trace_emitter_curves(scene)) {
        if (c.receiver != SurfaceId(receiver))
            continue;
        const PlaneFrame &frame = scene.surface(c.receiver).frame;
        lines.push_back({c.kind, c.order, scene.own.to_own(frame.to_space(c.from)),
                         scene.own.to_own(frame.to_space(c.to)), c.blockers});
    }
    return lines;
}

/// The curve between the two points, in either direction.
const Line *find(const std::vector<Line> &lines, const Vec3 &from, const Vec3 &to) {
    const auto found = std::ranges::find_if(lines, [&](const Line &l) {
        return ((l.from - from).norm() < accuracy && (l.to - to).norm() < accuracy) ||
               ((l.from - to).norm() < accuracy && (l.to - from).norm() < accuracy);
    });
    return found == lines.end() ? nullptr : &*found;
}

std::string all(const std::vector<Line> &lines) {
    std::ostringstream s;
    s.precision(8);
    for (const Line &l : lines)
        s << name(l.kind) << ' ' << l.order << "  " << l.from.transpose() << "  to  " << l.to.transpose() << '\n';
    return s.str();
}

TEST(ClosedForm, SlantedEdgeThrowsFourLinesOfSecondOrder) {
    // The blocker's left edge, from (0.11,-3) to (0.37,3) at half the light's height, is thrown by a light's corner
    // (u,v) to x = 2 e - (u,v): from a corner, x runs with twice the edge's slope over y. On the floor y is in [-2,2].
    const auto lines = curves_of(open_scene("slanted-edge"));
    EXPECT_EQ(lines.size(), 4U) << all(lines);
    for (const double u : {-0.5, 0.5})
        for (const double v : {-0.5, 0.5}) {
            const auto x = [&](double y) { return 2 * (0.11 + 0.26 / 6 * ((y + v) / 2 + 3)) - u; };
            const Line *line = find(lines, {x(-2), -2, 0}, {x(2), 2, 0});
            ASSERT_NE(line, nullptr) << u << ' ' << v << '\n' << all(lines);
            EXPECT_EQ(line->kind, CurveKind::ve);
            EXPECT_EQ(line->order, 2);
            EXPECT_THAT(line->blockers, testing::ElementsAre(SurfaceId(2)));
        }
}

TEST(ClosedForm, ParallelEdgesThrowOneLineOfFirstOrder) {
    // The edge x = 0.1 at half height: both corners of a side of the light throw it to 0.2 -+ 0.5.
    const auto lines =
        curves_of(scene_of(room + "v 0.1 -3 1\nv 3 -3 1\nv 3 3 1\nv 0.1 3 1\nf 9 10 11 12\n", materials));
    EXPECT_EQ(lines.size(), 2U) << all(lines);
    for (const double x : {-0.3, 0.7}) {
        const Line *line = find(lines, {x, -2, 0}, {x, 2, 0});
        ASSERT_NE(line, nullptr) << all(lines);
        EXPECT_EQ(line->order, 1);
    }
}

TEST(ClosedForm, BothSidesOfADoubledBlockerThrowOneCurve) {
    const auto once = curves_of(scene_of(room + "v 0.1 -3 1\nv 3 -3 1\nv 3 3 1\nv 0.3 3 1\nf 9 10 11 12\n", materials));
    const auto twice =
        curves_of(scene_of(room + "v 0.1 -3 1\nv 3 -3 1\nv 3 3 1\nv 0.3 3 1\nf 9 10 11 12\nf 12 11 10 9\n", materials));
    EXPECT_EQ(once.size(), 4U);
    EXPECT_EQ(twice.size(), once.size()) << all(twice);
}

TEST(ClosedForm, AQuadBehindALargerOneThrowsNothing) {
    // The upper plate hides all of the lower one from every point of the light: only the upper one's outline shows.
    const std::string upper = "v -0.9 -0.9 1.2\nv 0.9 -0.9 1.2\nv 0.9 0.9 1.2\nv -0.9 0.9 1.2\n";
    const std::string lower = "v -0.2 -0.2 1.1\nv 0.2 -0.2 1.1\nv 0.2 0.2 1.1\nv -0.2 0.2 1.1\n";
    const auto alone = curves_of(scene_of(room + upper + "f 9 10 11 12\n", materials));
    const auto both = curves_of(scene_of(room + upper + lower + "f 9 10 11 12\nf 13 14 15 16\n", materials));
    EXPECT_FALSE(alone.empty());
    EXPECT_EQ(all(both), all(alone));
}

TEST(ClosedForm, CornersOfASeparateBlockerThrowTheLightsEdges) {
    // A corner at half height throws the light's edge mirrored and at its own length: through (0.3,0.3,1) the edge
    // from (-0.5,0.5) to (0.5,0.5) goes to (1.1,0.1) to (0.1,0.1). The light is turned so that nothing is aligned.
    const std::string turned = "mtllib m\nv -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nusemtl grey\nf 1 2 3 4\n"
                               "v -0.4 -0.3 2\nv -0.3 0.5 2\nv 0.4 0.4 2\nv 0.5 -0.5 2\nusemtl lamp\nf 5 6 7 8\n"
                               "usemtl black\nv -0.3 -0.3 1\nv 0.3 -0.3 1\nv 0.3 0.3 1\nv -0.3 0.3 1\nf 9 10 11 12\n";
    const auto lines = curves_of(scene_of(turned, materials));
    const Line *line = find(lines, {0.6 + 0.3, 0.6 - 0.5, 0}, {0.6 - 0.4, 0.6 - 0.4, 0});
    ASSERT_NE(line, nullptr) << all(lines);
    EXPECT_EQ(line->kind, CurveKind::ev);
    EXPECT_EQ(line->order, 2);
    // Every corner throws every edge, every edge is thrown by every corner; two of them are parallel in no case.
    EXPECT_EQ(std::ranges::count(lines, CurveKind::ev, &Line::kind), 16) << all(lines);
    EXPECT_EQ(std::ranges::count(lines, CurveKind::ve, &Line::kind), 16) << all(lines);
    EXPECT_EQ(lines.size(), 32U);
}

TEST(ClosedForm, AThinWallHasContactAndPlane) {
    // A wall x = 0.8, |y| <= 0.5, 0.3 high, standing free of the light's side: D0 where it stands; beyond its ends its
    // plane is an edge-on view of it, which meets no light (the light ends at x = 0.5).
    const auto lines = curves_of(
        scene_of(room + "v 0.8 -0.5 0\nv 0.8 0.5 0\nv 0.8 0.5 0.3\nv 0.8 -0.5 0.3\nf 9 10 11 12\n", materials));
    const Line *contact = find(lines, {0.8, -0.5, 0}, {0.8, 0.5, 0});
    ASSERT_NE(contact, nullptr) << all(lines);
    EXPECT_EQ(contact->kind, CurveKind::contact);
    EXPECT_EQ(contact->order, 0);
    EXPECT_EQ(std::ranges::count(lines, CurveKind::plane, &Line::kind), 0);
}

TEST(ClosedForm, AWallUnderTheLightIsSeenEdgeOn) {
    // The wall x = 0.2, |y| <= 0.1, z from 0.5 to 1: from y = -0.7 the line over its near upper end (-0.1, 1) just
    // reaches the light's far border (0.5, 2); nearer to the middle it meets more of the light.
    const auto lines = curves_of(
        scene_of(room + "v 0.2 -0.1 0.5\nv 0.2 0.1 0.5\nv 0.2 0.1 1\nv 0.2 -0.1 1\nf 9 10 11 12\n", materials));
    const auto plane = std::ranges::find(lines, CurveKind::plane, &Line::kind);
    ASSERT_NE(plane, lines.end()) << all(lines);
    EXPECT_EQ(plane->order, 1);
    EXPECT_NE(find(lines, {0.2, -0.7, 0}, {0.2, 0.7, 0}), nullptr) << all(lines);
}

TEST(ClosedForm, ContactsOfABoxAreRealWhereTheLightIsSeen) {
    const Scene scene = open_scene("box-on-floor");
    const auto lines = curves_of(scene);
    // The box' foot is both the border of its cover and the sides' contact. The light is at x from 0.9 to 1.3 and y
    // from -0.6 to -0.2; it sees two of the sides, and the feet of the other two stand in full shadow.
    const Vec3 a(-0.143309106, -0.405539764, 0), b(0.430097325, -0.004036258, 0), c(0.143309106, 0.405539764, 0),
        d(-0.430097325, 0.004036258, 0);
    for (const auto &[from, to, real] :
         {std::tuple(a, b, true), std::tuple(b, c, true), std::tuple(c, d, false), std::tuple(d, a, false)}) {
        const Line *contact = find(lines, from, to);
        EXPECT_EQ(contact != nullptr && contact->kind == CurveKind::contact, real) << all(lines);
    }
}

} // namespace
} // namespace penumbra
