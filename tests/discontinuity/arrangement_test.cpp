// Arrangements: small ones by hand, Euler's formula and areas on scenes, and regions in which the visible part has one
// shape, read with no critical surface constructed (visible_shape.h).
#include "discontinuity/arrangement.h"

#include "discontinuity/trace_curves.h"
#include "random_rooms.h"
#include "scene/bundled.h"
#include "visible_shape.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <map>
#include <numbers>
#include <numeric>

namespace penumbra {
namespace {

using Lines = std::vector<std::vector<Vec2>>;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

const Polygon unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
constexpr double snap = 1e-9;

int n_components(const Arrangement &a) {
    std::vector<int> root(a.vertices.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int v) {
        while (root[static_cast<std::size_t>(v)] != v)
            v = root[static_cast<std::size_t>(v)];
        return v;
    };
    auto n = static_cast<int>(root.size());
    for (const ArrangementEdge &e : a.edges)
        if (const int p = find(e.from), q = find(e.to); p != q) {
            root[static_cast<std::size_t>(p)] = q;
            --n;
        }
    return n;
}

double total_area(const Arrangement &a) {
    double sum = 0;
    for (const ArrangementFace &f : a.faces)
        sum += f.area;
    return sum;
}

std::vector<double> areas(const Arrangement &a) {
    std::vector<double> all;
    for (const ArrangementFace &f : a.faces)
        all.push_back(f.area);
    return all;
}

/// V - E + F = 1 + C, counting the outside as a face.
void expect_euler(const Arrangement &a) {
    EXPECT_EQ(std::ssize(a.vertices) - std::ssize(a.edges) + std::ssize(a.faces) + 1, 1 + n_components(a));
}

Vec2 at(const Arrangement &a, int vertex) { return a.vertices[static_cast<std::size_t>(vertex)]; }

TEST(Arrangement, NoCurvesLeaveTheReceiverWhole) {
    const Arrangement a = arrange(unit_square, Lines{}, snap);
    EXPECT_EQ(a.vertices.size(), 4U);
    EXPECT_EQ(a.edges.size(), 4U);
    ASSERT_EQ(a.faces.size(), 1U);
    EXPECT_EQ(a.faces[0].outline.size(), 4U);
    EXPECT_EQ(a.faces[0].area, 1);
    for (const ArrangementEdge &e : a.edges) {
        EXPECT_TRUE(e.border && e.lines.empty());
        EXPECT_EQ(e.left + e.right, -1) << "the face, and the outside";
    }
}

// Two lines that cross, from side to side: 4 corners, 4 ends, 1 crossing; 8 pieces of the border, 4 of the lines.
TEST(Arrangement, ACross) {
    const Arrangement a = arrange(unit_square, Lines{{{0.5, 0}, {0.5, 1}}, {{0, 0.25}, {1, 0.25}}}, snap);
    EXPECT_EQ(a.vertices.size(), 9U);
    EXPECT_EQ(a.edges.size(), 12U);
    EXPECT_THAT(areas(a), UnorderedElementsAre(0.125, 0.125, 0.375, 0.375));
    expect_euler(a);
    for (const ArrangementEdge &e : a.edges)
        if (!e.border) {
            EXPECT_THAT(e.lines, ElementsAre(at(a, e.from).x() == at(a, e.to).x() ? 0 : 1));
        }
}

// What floats: an open line has one face about it, a triangle has one inside as well.
TEST(Arrangement, WhatFloatsIsAHole) {
    const Arrangement open = arrange(unit_square, Lines{{{0.2, 0.2}, {0.3, 0.4}}}, snap);
    ASSERT_EQ(open.faces.size(), 1U);
    EXPECT_EQ(open.faces[0].area, 1);
    ASSERT_EQ(open.faces[0].holes.size(), 1U);
    EXPECT_EQ(open.faces[0].holes[0].size(), 2U) << "there and back";
    expect_euler(open);

    const Arrangement closed = arrange(unit_square, Lines{{{0.2, 0.2}, {0.4, 0.2}, {0.2, 0.6}, {0.2, 0.2}}}, snap);
    EXPECT_THAT(areas(closed), UnorderedElementsAre(DoubleNear(0.96, 1e-15), DoubleNear(0.04, 1e-15)));
    EXPECT_EQ(n_components(closed), 2);
    expect_euler(closed);
}

/// An L: the square on [0, 2] without its upper right quarter; the line ends at the corner that turns in.
TEST(Arrangement, ConcaveReceiver) {
    const Polygon l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    const Arrangement a = arrange(l, Lines{{{0, 0.5}, {1, 1}}}, snap);
    EXPECT_THAT(areas(a), UnorderedElementsAre(DoubleNear(1.25, 1e-14), DoubleNear(1.75, 1e-14)));
    expect_euler(a);
}

/// What sticks out of the receiver is cut off.
TEST(Arrangement, NothingOutside) {
    const Arrangement a = arrange(unit_square, Lines{{{-0.5, 0.5}, {1.5, 0.5}}}, snap);
    EXPECT_EQ(a.vertices.size(), 6U);
    EXPECT_EQ(a.edges.size(), 7U);
    EXPECT_THAT(areas(a), UnorderedElementsAre(0.5, 0.5));
}

/// A line that stops 1e-12 short of another, and one that passes it by as much, close their regions.
TEST(Arrangement, GapsOfRoundingAreClosed) {
    const Arrangement a =
        arrange(unit_square,
                Lines{{{0.5, 0}, {0.5, 1}}, {{0, 0.25}, {0.5 - 1e-12, 0.25}}, {{0.5 - 1e-12, 0.75}, {1, 0.75}}}, snap);
    EXPECT_THAT(areas(a), UnorderedElementsAre(DoubleNear(0.125, 1e-9), DoubleNear(0.375, 1e-9),
                                               DoubleNear(0.375, 1e-9), DoubleNear(0.125, 1e-9)));
    EXPECT_EQ(a.vertices.size(), 10U);
    expect_euler(a);
}

/// Three lines through one point, to rounding: six faces, no seventh between them.
TEST(Arrangement, ThreeLinesThroughOnePoint) {
    const double off = 3e-13;
    const Arrangement a = arrange(
        unit_square, Lines{{{0.3 + off, 0}, {0.3 - off, 1}}, {{0, 0.4}, {1, 0.4}}, {{0, 0.1 - off}, {0.9, 1}}}, snap);
    EXPECT_EQ(a.faces.size(), 6U);
    EXPECT_EQ(a.vertices.size(), 4U + 6U + 1U);
    EXPECT_NEAR(total_area(a), 1, 1e-15);
    expect_euler(a);
}

/// Of two lights, in one line: the piece that both run along knows both.
TEST(Arrangement, CurvesInOneLine) {
    const Arrangement a = arrange(unit_square, Lines{{{0, 0.5}, {0.6, 0.5}}, {{0.4, 0.5}, {1, 0.5}}}, snap);
    std::map<double, std::vector<int>> by_middle;
    for (const ArrangementEdge &e : a.edges)
        if (!e.border)
            by_middle[(at(a, e.from).x() + at(a, e.to).x()) / 2] = e.lines;
    ASSERT_EQ(by_middle.size(), 3U);
    EXPECT_THAT(by_middle.begin()->second, ElementsAre(0));
    EXPECT_THAT(std::next(by_middle.begin())->second, ElementsAre(0, 1));
    EXPECT_THAT(by_middle.rbegin()->second, ElementsAre(1));
    EXPECT_EQ(a.faces.size(), 2U);
}

/// A quarter of a circle, as a rational curve: pi/4 and the rest.
TEST(Arrangement, ArcsAreChords) {
    Surface receiver;
    receiver.outline = unit_square;
    const double w = std::sqrt(0.5);
    Curve quarter;
    quarter.from = {1, 0};
    quarter.to = {0, 1};
    quarter.control = {w, w, w};
    const Arrangement a = arrange(receiver, std::vector{quarter});
    EXPECT_THAT(areas(a), UnorderedElementsAre(DoubleNear(std::numbers::pi / 4, 2.3e-6),
                                               DoubleNear(1 - std::numbers::pi / 4, 2.3e-6)));
    EXPECT_NEAR(total_area(a), 1, 1e-14);
}

/// The curves of one receiver, arranged.
struct Arranged {
    std::vector<Curve> curves;
    Arrangement arrangement;

    Arranged(const Scene &scene, const std::vector<Curve> &all, SurfaceId receiver) {
        std::ranges::copy_if(all, std::back_inserter(curves), [&](const Curve &c) { return c.receiver == receiver; });
        arrangement = arrange(scene.surface(receiver), curves);
    }
};

/// Euler's formula; faces tile the receiver; pieces lie on their curves, and each curve has pieces for all its length.
void expect_sound(const Scene &scene) {
    const std::vector<Curve> all = trace_emitter_curves(scene);
    for (int r = 0; r < scene.n_surfaces(); ++r) {
        if (!scene.reflects(SurfaceId(r)))
            continue;
        const Surface &receiver = scene.surface(SurfaceId(r));
        const auto [curves, a] = Arranged(scene, all, SurfaceId(r));
        expect_euler(a);
        EXPECT_NEAR(total_area(a), receiver.area, 1e-8);
        for (const ArrangementFace &face : a.faces)
            EXPECT_GT(face.area, 0);
        std::vector<double> length(curves.size(), 0);
        for (std::size_t i = 0; i < a.edges.size(); ++i) {
            const ArrangementEdge &e = a.edges[i];
            EXPECT_TRUE(e.border || !e.lines.empty());
            EXPECT_EQ(e.left < 0 || e.right < 0, e.border) << "the outside is beyond the border only";
            for (const int line : e.lines) {
                const auto c = static_cast<std::size_t>(line);
                length[c] += (at(a, e.to) - at(a, e.from)).norm();
                const double off = i % 16 == 0 ? distance(curves[c], (at(a, e.from) + at(a, e.to)) / 2) : 0; // slow
                EXPECT_LE(off, 2e-6 * radius(receiver.outline) + 1e-8);
            }
        }
        for (std::size_t c = 0; c < curves.size(); ++c) {
            double whole = 0;
            const auto points = polyline(curves[c], 1e-7);
            for (std::size_t i = 0; i + 1 < points.size(); ++i)
                whole += (points[i + 1] - points[i]).norm();
            EXPECT_NEAR(length[c], whole, 1e-6);
        }
    }
}

TEST(Arrangement, SoundOnBundledScenes) {
    for (const char *name : {"figure-4", "cornell-box", "skew-blockers", "stairs", "table", "pierced", "next-room",
                             "venetian-blinds", "three-blockers"}) {
        SCOPED_TRACE(name);
        expect_sound(open_scene(name));
    }
}

TEST(Arrangement, SoundOnRandomScenes) {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        ObjText text = turned_room(random);
        for (std::uint32_t i = 0; i < 1 + seed % 4; ++i)
            add_quad(text, random, random.in({-0.9, -0.9, 0.4}, {0.9, 0.9, 1.6}));
        add_box(text, random, random.in({-1, -1, 0.2}, {1, 1, 0.9}), seed % 2 == 0);
        expect_sound(text.scene());
    }
}

bool inside(const Arrangement &a, const std::vector<int> &cycle, const Vec2 &p) {
    bool odd = false;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
        const Vec2 q = at(a, cycle[i]) - p, r = at(a, cycle[(i + 1) % cycle.size()]) - p;
        if ((q.y() > 0) != (r.y() > 0) && (cross(q, r) > 0) == (r.y() > q.y()))
            odd = !odd;
    }
    return odd;
}

int face_at(const Arrangement &a, const Vec2 &p) {
    for (std::size_t f = 0; f < a.faces.size(); ++f)
        if (inside(a, a.faces[f].outline, p) &&
            std::ranges::none_of(a.faces[f].holes, [&](const auto &hole) { return inside(a, hole, p); }))
            return static_cast<int>(f);
    return -1;
}

/// Wherever two points lie in one region, what is seen of the light has the same shape. A gap between two curves would
/// join regions of different shapes.
void expect_one_shape_a_region(const Scene &scene, SurfaceId source, SurfaceId receiver, int n_points) {
    const auto [curves, a] = Arranged(scene, trace_emitter_curves(scene), receiver);
    const ShapeReader reader(scene, source, receiver);
    const Polygon &outline = scene.surface(receiver).outline;
    Vec2 low = outline[0], high = outline[0];
    for (const Vec2 &p : outline) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    Random random(1);
    std::map<int, VisibleShape> shapes;
    int n_compared = 0;
    for (int i = 0; i < n_points; ++i) {
        const Vec2 p(random.in(low.x(), high.x()), random.in(low.y(), high.y()));
        if (std::ranges::any_of(curves, [&](const Curve &c) { return distance(c, p) < 1e-5; }))
            continue;
        const int face = face_at(a, p);
        ASSERT_GE(face, 0);
        const auto [known, is_new] = shapes.emplace(face, reader.at(p));
        if (!is_new) {
            ++n_compared;
            EXPECT_EQ(reader.at(p), known->second) << "face " << face << ", " << p.transpose();
        }
    }
    EXPECT_GT(n_compared, n_points / 2);
    EXPECT_GT(shapes.size(), 10U);
}

TEST(Arrangement, OneShapeARegionOfSkewBlockers) {
    expect_one_shape_a_region(open_scene("skew-blockers"), SurfaceId(1), SurfaceId(0), 1000);
}
TEST(Arrangement, OneShapeARegionOfThreeBlockers) {
    expect_one_shape_a_region(open_scene("three-blockers"), SurfaceId(1), SurfaceId(0), 2000);
}
TEST(Arrangement, OneShapeARegionOfTheTablesFloor) {
    expect_one_shape_a_region(open_scene("table"), SurfaceId(1), SurfaceId(0), 1000);
}
TEST(Arrangement, OneShapeARegionOfVenetianBlinds) {
    expect_one_shape_a_region(open_scene("venetian-blinds"), SurfaceId(1), SurfaceId(0), 1000);
}

} // namespace
} // namespace penumbra
