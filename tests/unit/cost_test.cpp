// The study of costs: in which order it runs, what it leaves out and records; and the limits of a run.
#include "study/cost.h"
#include "study/solve_for_reference.h"

#include "core/error.h"
#include "iteration/solver.h"
#include "scene/bundled.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

namespace penumbra {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::Gt;
using testing::SizeIs;

std::shared_ptr<const Scene> scene(const char *name) {
    return std::make_shared<const Scene>(open_scene(name, std::nullopt));
}

struct Asked {
    Strategy strategy;
    BasisFamily basis;
    double threshold;
    int repeat;

    auto operator<=>(const Asked &) const = default;
};

/// Solves nothing: writes down what is asked, and answers as told.
struct Script {
    std::vector<Asked> asked;
    std::function<CostRun(const Options &, int n)> answer; ///< n: how often the same was asked before

    CostRunner runner() {
        return [this](const Options &o, int repeat) {
            const Asked now{o.strategy, o.basis, o.threshold, repeat};
            const auto before = std::ranges::count_if(asked, [&](const Asked &a) {
                return a.strategy == now.strategy && a.basis == now.basis && a.threshold == now.threshold;
            });
            asked.push_back(now);
            return answer(o, static_cast<int>(before));
        };
    }
};

CostRun done_in(double seconds) {
    CostRun run;
    run.seconds = seconds;
    run.counters.iteration = 1;
    run.error = 0.5;
    return run;
}

CostRun ended(RunEnd end) {
    CostRun run = done_in(9);
    run.end = end;
    return run;
}

TEST(Cost, EachIsSolvedAsOftenAsAskedAfterARunThatDoesNotCount) {
    CostRange range;
    range.thresholds = {0.1, 0.01, 0.1}; // what is named twice is one
    Script script{{}, [](const Options &, int n) { return done_in(1 + n); }};
    const auto points = measure_cost(range, script.runner());
    ASSERT_EQ(points.size(), 4U * 2U * 2U);
    EXPECT_EQ(script.asked.size(), 1U + 3U * points.size());
    for (const CostPoint &p : points) {
        EXPECT_EQ(p.end, RunEnd::done);
        EXPECT_EQ(p.n_runs(), 3);
        // The first one was asked once more than the others, and that run does not count.
        const double first = &p == &points.front() ? 2 : 1;
        EXPECT_THAT(p.seconds, testing::UnorderedElementsAre(first, first + 1, first + 2));
    }
    EXPECT_EQ(points[0].options.threshold, 0.1);
    EXPECT_EQ(points[1].options.threshold, 0.01) << "from the loosest";
}

TEST(Cost, TheErrorIsMeasuredOnceAndRepeatsAreShuffled) {
    CostRange range;
    range.thresholds = {0.01, 0.1, 0.03};
    Script script{{}, [](const Options &, int) { return done_in(1); }};
    measure_cost(range, script.runner());
    const std::size_t n = 4 * 2 * 3;
    const auto begin = script.asked.begin() + 1; // past the warming up
    std::vector<Asked> firsts(begin, begin + n), repeats(begin + n, script.asked.end());
    for (std::size_t i = 0; i < n; ++i) {
        EXPECT_EQ(firsts[i].repeat, 0);
        EXPECT_EQ(firsts[i].threshold, i % 3 == 0 ? 0.1 : i % 3 == 1 ? 0.03 : 0.01) << "from the loosest";
    }
    EXPECT_FALSE(std::ranges::is_sorted(firsts, {}, &Asked::strategy)) << "curves are shuffled";
    EXPECT_FALSE(std::ranges::is_sorted(repeats, {}, &Asked::strategy));
    EXPECT_THAT(repeats, Each(testing::Field(&Asked::repeat, Gt(0))));
    std::map<Asked, int> times;
    for (const Asked &a : repeats)
        ++times[a];
    EXPECT_EQ(times.size(), n);
    EXPECT_TRUE(std::ranges::all_of(times, [](const auto &t) { return t.second == 2; }));

    Script again{{}, script.answer};
    measure_cost(range, again.runner());
    EXPECT_EQ(again.asked, script.asked) << "the same order in every study";
}

TEST(Cost, PastALimitFinerThresholdsAreNotTriedAndStandThereAsSuch) {
    CostRange range;
    range.bases = {BasisFamily::planar};
    range.thresholds = {0.1, 0.03, 0.01, 0.003};
    for (const RunEnd end : {RunEnd::time_limit, RunEnd::memory_limit, RunEnd::failed, RunEnd::not_converged}) {
        Script script{{}, [&](const Options &o, int) {
                          return o.strategy == Strategy::uniform_constant && o.threshold < 0.05 ? ended(end) : done_in(1);
                      }};
        int last_done = 0, last_all = 0;
        const auto points = measure_cost(range, script.runner(), [&](const CostPoint &, int done, int all) {
            last_done = done;
            last_all = all;
        });
        std::vector<RunEnd> ends;
        for (const CostPoint &p : points)
            if (p.options.strategy == Strategy::uniform_constant)
                ends.push_back(p.end);
        EXPECT_THAT(ends, ElementsAre(RunEnd::done, end, RunEnd::not_tried, RunEnd::not_tried));
        EXPECT_EQ(points[1].n_runs(), 0);
        EXPECT_THAT(points[1].seconds, ElementsAre(9)) << "stopped after so long, and not tried again";
        EXPECT_EQ(std::ranges::count(points, RunEnd::done, &CostPoint::end), 1 + 3 * 4) << "other curves go on";
        // Of 16 points three times each, two runs of one and all of two fall away.
        EXPECT_EQ(last_all, 16 * 3 - 2 - 2 * 3);
        EXPECT_EQ(last_done, last_all);
    }
}

TEST(Cost, ARepeatThatMeetsTheLimitIsLeftOutOfTheMedian) {
    CostRange range;
    range.strategies = {Strategy::uniform_wavelet};
    range.bases = {BasisFamily::planar};
    range.thresholds = {0.1};
    Script script{{}, [](const Options &, int n) { return n == 2 ? ended(RunEnd::time_limit) : done_in(n); }};
    const auto points = measure_cost(range, script.runner());
    EXPECT_EQ(points[0].end, RunEnd::done);
    EXPECT_THAT(points[0].seconds, ElementsAre(1, 3));
}

TEST(Cost, OnceCancelledTheRestIsInterruptedAndWhatWasDoneStays) {
    CostRange range;
    range.bases = {BasisFamily::planar};
    range.thresholds = {0.1, 0.03, 0.01};
    int n_runs = 0;
    Script script{{}, [&](const Options &o, int) -> CostRun {
                      if (++n_runs == 7)
                          throw Cancelled();
                      return o.threshold < 0.05 && n_runs == 3 ? ended(RunEnd::time_limit) : done_in(1);
                  }};
    const auto points = measure_cost(range, script.runner());
    std::map<RunEnd, int> n;
    for (const CostPoint &p : points)
        ++n[p.end];
    // After the one that does not count: done, time limit (and one not tried), done, done, done, cancelled.
    EXPECT_EQ(n[RunEnd::done], 4);
    EXPECT_EQ(n[RunEnd::time_limit], 1);
    EXPECT_EQ(n[RunEnd::not_tried], 1);
    EXPECT_EQ(n[RunEnd::interrupted], 6);
}

TEST(Cost, OfARealSceneIsTheSolversOwnFiguresAndItsTrueError) {
    const auto slanted = scene("slanted-edge");
    Options options;
    options.strategy = Strategy::discontinuity_wavelet;
    options.threshold = 0.01;
    const Cancel cancel;
    const CostRunner run = solving_runner(slanted, error_against(slanted, nullptr), {}, cancel);
    const CostRun first = run(options, 0), second = run(options, 1);
    Solver solver(slanted, options);
    solver.run();
    EXPECT_EQ(first.end, RunEnd::done);
    EXPECT_EQ(first.counters.patches, solver.counters().patches);
    EXPECT_EQ(first.counters.total_work.kernel_evaluations, solver.counters().total_work.kernel_evaluations);
    EXPECT_EQ(first.error, solver.snapshot(true)->error);
    EXPECT_GT(first.error, 0);
    EXPECT_LT(first.error, options.threshold);
    EXPECT_LT(second.error, 0) << "not measured again";
    EXPECT_GT(first.seconds, first.counters.seconds) << "tracing the curves counts for a strategy that cuts";
}

TEST(Cost, WhereLightIsReflectedMoreOftenAReferenceTellsTheError) {
    // The solver's own estimate of a coarse solution comes from rays, the error here from a gather of a fine one.
    const auto stairs = scene("stairs");
    const TrueError error = error_against(
        stairs, std::make_shared<const Reference>(stairs, solve_for_reference(stairs, 0.01)));
    Solver solver(stairs, Options().to_tolerance(0.1));
    ASSERT_TRUE(solver.run());
    const double found = error(*solver.state());
    EXPECT_LT(found, 0.1);
    EXPECT_LT(std::abs(std::log(solver.counters().estimated_error / found)), std::log(1.4));
}

TEST(Cost, ARunIsStoppedByItsLimitAndKeepsItsLastCompleteIteration) {
    const auto slanted = scene("slanted-edge");
    Options hard;
    hard.strategy = Strategy::uniform_constant;
    hard.threshold = 1e-4;
    hard.max_depth = 14;
    const Cancel cancel;
    RunLimits limits;
    limits.seconds = 0.3;
    const CostRun run = solving_runner(slanted, error_against(slanted, nullptr), limits, cancel)(hard, 0);
    EXPECT_EQ(run.end, RunEnd::time_limit);
    EXPECT_GE(run.seconds, 0.29); // the clock of the limit starts a moment before
    EXPECT_GT(run.counters.iteration, 0);
    EXPECT_GT(run.error, 0);

    limits = {};
    limits.memory_mib = 1; // the program alone has more
    EXPECT_EQ(solving_runner(slanted, {}, limits, cancel)(hard, 0).end, RunEnd::memory_limit);
}

TEST(Cost, ACancelFromOutsideEndsTheRunAndTheStudy) {
    const auto slanted = scene("slanted-edge");
    Options hard;
    hard.strategy = Strategy::uniform_constant;
    hard.threshold = 1e-4;
    hard.max_depth = 14;
    Cancel cancel;
    const CostRunner run = solving_runner(slanted, {}, {}, cancel);
    std::jthread later([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        cancel.raise();
    });
    EXPECT_THROW(run(hard, 0), Cancelled);
}

} // namespace
} // namespace penumbra
