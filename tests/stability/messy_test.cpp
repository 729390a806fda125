// Scenes as people's files bring them: what is in them twice, turned round or sunk in changes nothing that it should not.
#include "iteration/probe.h"
#include "iteration/solver.h"
#include "unit/obj_text.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace penumbra {
namespace {

const std::string materials = "newmtl grey\nKd 0.8 0.8 0.8\nnewmtl lamp\nKd 0.8 0.8 0.8\nKe 10 10 10\n";

/// A floor of side 5 (vertices 1 to 4), a lamp of side 1 at height 3 to one side of the middle (5 to 8), and a unit cube
/// turned by half a radian whose foot is `sunk` below the floor.
std::string room(double sunk = 0) {
    std::string obj = "mtllib m\nv -2.5 -2.5 0\nv 2.5 -2.5 0\nv 2.5 2.5 0\nv -2.5 2.5 0\n"
                      "v 0.3 -0.5 3\nv 0.3 0.5 3\nv 1.3 0.5 3\nv 1.3 -0.5 3\n";
    const double c = std::cos(0.5) / 2, s = std::sin(0.5) / 2;
    for (const double z : {-sunk, 1 - sunk})
        obj += fmt::format("v {} {} {}\nv {} {} {}\nv {} {} {}\nv {} {} {}\n", -c + s, -s - c, z, c + s, s - c, z, c - s,
                           s + c, z, -c - s, -s + c, z);
    return obj + "usemtl grey\nf 9 12 11 10\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n"
                 "f 1 2 3 4\nusemtl lamp\nf 5 6 7 8\n";
}

std::shared_ptr<const Snapshot> solve(const std::string &obj) {
    Options options;
    Solver solver(std::make_shared<const Scene>(scene_of(obj, materials)), options);
    EXPECT_TRUE(solver.run());
    EXPECT_EQ(solver.counters().total_work.sampled_visibility, 0);
    return solver.snapshot();
}

/// Largest difference of radiosity on the floor, looked at from above, as a fraction of the peak.
double difference(const Snapshot &a, const Snapshot &b) {
    double most = 0;
    int n_seen = 0;
    for (double x = -2.4; x < 2.5; x += 0.16)
        for (double y = -2.4; y < 2.5; y += 0.16) {
            const auto p = radiosity_at(a, {x, y, 0}, {0, 0, 1}, 1e-6), q = radiosity_at(b, {x, y, 0}, {0, 0, 1}, 1e-6);
            EXPECT_EQ(p.has_value(), q.has_value()) << x << " " << y;
            if (!p || !q)
                continue;
            ++n_seen;
            most = std::max(most, (*p - *q).abs().maxCoeff());
        }
    EXPECT_GT(n_seen, 500);
    return most / a.peak;
}

TEST(Messy, ALampThatIsThereTwiceIsOneLamp) {
    // The covered twin comes first, and throws the same curves: they must cut for the one that shines.
    const auto once = solve(room()), twice = solve(room() + "f 5 6 7 8\n");
    EXPECT_LT(difference(*once, *twice), 0.01);
    EXPECT_LE(twice->counters.patches, once->counters.patches + 4);
    EXPECT_EQ(twice->counters.nodes_at_limit, once->counters.nodes_at_limit);
}

TEST(Messy, AFloorWithABackIsStillLit) {
    const auto plain = solve(room()), sheet = solve(room() + "usemtl grey\nf 4 3 2 1\n");
    EXPECT_LT(difference(*plain, *sheet), 0.01);
}

TEST(Messy, AHairBelowOrAboveTheFloorIsOnIt) {
    const auto on = solve(room());
    for (const double sunk : {1e-7, -1e-7})
        EXPECT_LT(difference(*on, *solve(room(sunk))), 0.1) << sunk;
}

TEST(Messy, StackedCubesAreDarkBetween) {
    // A second cube of the same size on the first: top and bottom are back to back, inside the two.
    std::string obj = room();
    const double c = std::cos(0.5) / 2, s = std::sin(0.5) / 2;
    obj += fmt::format("v {} {} 2\nv {} {} 2\nv {} {} 2\nv {} {} 2\nusemtl grey\n", -c + s, -s - c, c + s, s - c, c - s,
                       s + c, -c - s, -s + c);
    obj += "f 13 16 15 14\nf 17 18 19 20\nf 13 14 18 17\nf 14 15 19 18\nf 15 16 20 19\nf 16 13 17 20\n";
    const auto snapshot = solve(obj);
    for (const double up : {1.0, -1.0})
        for (const double x : {-0.2, 0.0, 0.2}) {
            const auto b = radiosity_at(*snapshot, {x, 0.1, 1}, {0, 0, up}, 1e-6);
            ASSERT_TRUE(b) << x;
            EXPECT_LT(b->abs().maxCoeff(), 1e-3 * snapshot->peak) << x;
        }
}

} // namespace
} // namespace penumbra
