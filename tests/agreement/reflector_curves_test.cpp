// Curves of reflectors, made when a node fails because of their light.
#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace penumbra {
namespace {

std::shared_ptr<const Scene> cornell_box() { return std::make_shared<const Scene>(open_scene("cornell-box")); }

Options options_of(int threads, bool reflector_curves = true) {
    Options options;
    options.threshold = 0.01;
    options.threads = threads;
    options.effects[Effect::curves_secondary] = reflector_curves ? Switch::automatic : Switch::off;
    return options;
}

TEST(ReflectorCurves, ComeAfterTheEmittersOnceForEachPair) {
    const auto scene = cornell_box();
    Solver solver(scene, options_of(0));
    const auto first = solver.state();
    const std::size_t n_emitters = first->curves->curves().size();
    for (const Curve &c : first->curves->curves())
        EXPECT_TRUE(scene->emits(c.source));
    solver.run();
    const auto &all = solver.state()->curves->curves();
    EXPECT_GT(all.size(), n_emitters);
    std::set<std::pair<SurfaceId, SurfaceId>> seen;
    for (std::size_t c = n_emitters; c < all.size(); ++c) {
        EXPECT_FALSE(scene->emits(all[c].source));
        const std::pair path{all[c].receiver, all[c].source};
        const bool begins = c == n_emitters || path != std::pair{all[c - 1].receiver, all[c - 1].source};
        EXPECT_EQ(seen.insert(path).second, begins) << "those of a pair stand together";
    }
    EXPECT_EQ(solver.counters().curves, static_cast<int>(all.size()));
    EXPECT_EQ(solver.snapshot()->curves->size(), all.size());
    // What was known before is as it was: for the state that is kept, and in the new list.
    EXPECT_EQ(first->curves->curves().size(), n_emitters);
    EXPECT_EQ(first->drawn_curves->size(), n_emitters);
    for (std::size_t c = 0; c < n_emitters; ++c)
        EXPECT_EQ(all[c].from, first->curves->curves()[c].from);
}

TEST(ReflectorCurves, AreTheSameForAnyNumberOfThreadsAndAfterGoingBack) {
    Solver one(cornell_box(), options_of(1)), four(cornell_box(), options_of(4));
    const auto start = four.state();
    four.run();
    four.restore(start);
    EXPECT_EQ(four.counters().curves, static_cast<int>(start->curves->curves().size()));
    one.run();
    four.run();
    const auto &a = one.state()->curves->curves(), &b = four.state()->curves->curves();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t c = 0; c < a.size(); ++c) {
        EXPECT_EQ(a[c].from, b[c].from);
        EXPECT_EQ(a[c].to, b[c].to);
        EXPECT_EQ(a[c].source, b[c].source);
    }
    EXPECT_EQ(one.counters().patches, four.counters().patches);
}

TEST(ReflectorCurves, SavePatchesWhereReflectorsThrowShadows) {
    // The walls of the Cornell box throw shadows where its blocks stand on the floor, on the sides that the lamp never
    // reaches: without their curves, uniform splits run along these edges down to the depth limit.
    Solver with(cornell_box(), options_of(0)), without(cornell_box(), options_of(0, false));
    with.run();
    without.run();
    EXPECT_LE(2 * with.counters().patches, without.counters().patches);
    EXPECT_LT(with.counters().nodes_at_limit, without.counters().nodes_at_limit);
}

} // namespace
} // namespace penumbra
