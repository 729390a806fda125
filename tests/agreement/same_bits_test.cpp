// The same bits for any number of threads, after a cancelled step, and after going back.
#include "iteration/solver.h"
#include "iteration/state.h"
#include "sanitizers/time_factor.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <thread>

namespace penumbra {
namespace {

std::shared_ptr<const Scene> cornell_box() { return std::make_shared<const Scene>(open_scene("cornell-box")); }

Options loose(int threads, GatherOrder gather = GatherOrder::jacobi) {
    Options options;
    options.threshold = 0.02;
    options.gather = gather;
    options.threads = threads;
    return options;
}

constexpr int n_steps = 4;

void expect_same_bits(const State &a, const State &b) {
    EXPECT_EQ(a.phase, b.phase);
    ASSERT_EQ(a.forest.elements.size(), b.forest.elements.size());
    for (std::size_t e = 0; e < a.forest.elements.size(); ++e)
        for (std::size_t c = 0; c < 4; ++c)
            ASSERT_EQ(a.forest.elements[e].basis.quad()->corners[c], b.forest.elements[e].basis.quad()->corners[c]);
    ASSERT_EQ(a.radiosity.rows(), b.radiosity.rows());
    int n_different = 0;
    for (Eigen::Index i = 0; i < a.radiosity.size(); ++i)
        n_different +=
            std::bit_cast<std::uint64_t>(a.radiosity.data()[i]) != std::bit_cast<std::uint64_t>(b.radiosity.data()[i]);
    EXPECT_EQ(n_different, 0) << "of " << a.radiosity.size();
    EXPECT_EQ(a.counters.links, b.counters.links);
    EXPECT_EQ(a.counters.total_work.kernel_evaluations, b.counters.total_work.kernel_evaluations);
    EXPECT_EQ(a.counters.total_work.clips, b.counters.total_work.clips);
    EXPECT_EQ(a.counters.change, b.counters.change);
}

std::shared_ptr<const State> after_steps(int threads, GatherOrder gather = GatherOrder::jacobi) {
    Solver solver(cornell_box(), loose(threads, gather));
    for (int i = 0; i < n_steps; ++i)
        solver.step();
    return solver.state();
}

TEST(SameBits, ForAnyNumberOfThreads) {
    const auto one = after_steps(1);
    EXPECT_GT(one->forest.elements.size(), 40U);
    EXPECT_GT(one->peak, 0);
    for (const int threads : {2, 4})
        expect_same_bits(*one, *after_steps(threads));
}

TEST(SameBits, InWhateverOrderLightIsGathered) {
    for (const GatherOrder order : {GatherOrder::gauss_seidel, GatherOrder::southwell}) {
        const auto one = after_steps(1, order);
        EXPECT_GT(one->peak, 0);
        expect_same_bits(*one, *after_steps(4, order));
    }
}

TEST(SameBits, AfterACancelledStep) {
    Solver solver(cornell_box(), loose(2));
    solver.step();
    const auto before = solver.state();
    int n_cancelled = 0; // a step may be done before a late flag rises
    for (const int milliseconds : {1, 3, 10, 30}) {
        Cancel cancel;
        std::chrono::steady_clock::time_point raised;
        std::jthread later([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
            raised = std::chrono::steady_clock::now();
            cancel.raise();
        });
        try {
            solver.step(&cancel);
            later.join();
            solver.restore(before);
        } catch (const Cancelled &) {
            const auto stopped = std::chrono::steady_clock::now();
            later.join();
            // 100 ms are promised on a machine that has nothing else to do; tests run beside each other.
            EXPECT_LT(std::chrono::duration<double>(stopped - raised).count(), 0.5 * time_factor);
            EXPECT_EQ(solver.state(), before);
            ++n_cancelled;
        }
    }
    EXPECT_GE(n_cancelled, 1);
    for (int i = 1; i < n_steps; ++i)
        solver.step();
    expect_same_bits(*solver.state(), *after_steps(2));
}

TEST(SameBits, AfterGoingBack) {
    Solver solver(cornell_box(), loose(0));
    solver.step();
    const auto first = solver.state();
    solver.step();
    solver.sub_step();
    const auto second = solver.state();
    solver.step();
    solver.restore(first);
    EXPECT_EQ(solver.counters().iteration, 1);
    solver.step();
    solver.sub_step();
    expect_same_bits(*solver.state(), *second);
}

} // namespace
} // namespace penumbra
