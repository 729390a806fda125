// From the states that a window has come to, to the plot of their costs.
#include "plot/live_cost.h"
#include "price_book.h"

#include <gmock/gmock.h>

#include <memory>

namespace penumbra {
namespace {

/// Iterations are complete at every third position; each has half the error and twice the price of the one before.
Timeline timeline_of(Strategy strategy, int iterations, bool true_error) {
    Timeline timeline;
    for (int p = 0; p <= 3 * iterations; ++p) {
        Snapshot s;
        s.options.strategy = strategy;
        s.counters.iteration = iteration_of(p);
        const double doublings = 1 << iteration_of(p);
        s.counters.seconds = 0.01 * doublings;
        s.counters.patches = static_cast<int>(doublings);
        s.counters.coefficients = 16 * s.counters.patches;
        s.counters.link_coefficients = 256 * s.counters.patches;
        s.counters.total_work.kernel_evaluations = 1000 * s.counters.patches;
        (true_error ? s.error : s.counters.estimated_error) = 0.4 / doublings;
        timeline.moments.push_back(std::make_shared<Snapshot>(s));
    }
    return timeline;
}

TEST(PriceBook, HasCompleteIterationsWithAKnownError) {
    Timeline timeline = timeline_of(Strategy::uniform_wavelet, 3, true);
    auto blind = std::make_shared<Snapshot>(*timeline.moments[6]);
    blind->error = -1; // and not estimated
    timeline.moments[6] = blind;
    const auto states = priced_states(timeline);
    ASSERT_EQ(states.size(), 2U);
    EXPECT_EQ(states[0].position, 3);
    EXPECT_EQ(states[1].position, 9);
    EXPECT_EQ(states[1].error(), 0.05);
    EXPECT_FALSE(states[1].estimated());
    EXPECT_TRUE(priced_states(timeline_of(Strategy::uniform_wavelet, 1, false)).front().estimated());
    EXPECT_TRUE(priced_states({}).empty());
}

TEST(PriceBook, KeepsTheLastRunOfEachKind) {
    PriceBook book;
    book.keep({});
    EXPECT_TRUE(book.runs.empty());
    book.keep(timeline_of(Strategy::uniform_wavelet, 1, true));
    book.keep(timeline_of(Strategy::uniform_constant, 1, true));
    book.keep(timeline_of(Strategy::uniform_wavelet, 2, true));
    ASSERT_EQ(book.runs.size(), 2U);
    EXPECT_EQ(book.runs[1].size(), 2U);
}

std::vector<LiveRun> runs() {
    return {{priced_states(timeline_of(Strategy::uniform_constant, 3, true)), 6, false},
            {priced_states(timeline_of(Strategy::discontinuity_wavelet, 2, false)), 6, false},
            {priced_states(timeline_of(Strategy::uniform_constant, 1, true)), -1, true}};
}

TEST(LiveCost, EveryStateIsAMarkInsideTheAxes) {
    for (const CostMeasure measure : all_cost_measures) {
        const auto all = runs();
        const Plot plot = live_cost_plot(all, measure, Theme::dark);
        EXPECT_EQ(plot.x_title, title(measure));
        ASSERT_EQ(plot.curves.size(), 3U);
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_EQ(plot.curves[c].marks.size(), all[c].states.size());
            for (std::size_t i = 0; i < all[c].states.size(); ++i) {
                const PlotMark &m = plot.curves[c].marks[i];
                EXPECT_EQ(m.x, value(measure, all[c].states[i].counters));
                EXPECT_GT(plot.x.place(m.x), 0);
                EXPECT_LT(plot.x.place(m.x), 1);
                EXPECT_GT(plot.y.place(m.y), 0);
                EXPECT_LT(plot.y.place(m.y), 1);
            }
        }
    }
}

TEST(LiveCost, MeasuresAreWhatTheySay) {
    const Counters c = runs()[0].states[0].counters;
    EXPECT_EQ(value(CostMeasure::seconds, c), 0.02);
    EXPECT_EQ(value(CostMeasure::patches, c), 2);
    EXPECT_EQ(value(CostMeasure::coefficients, c), 32);
    EXPECT_EQ(value(CostMeasure::link_coefficients, c), 512);
    EXPECT_EQ(value(CostMeasure::kernel_evaluations, c), 2000);
    for (const CostMeasure m : all_cost_measures)
        EXPECT_EQ(cost_measure_from_name(name(m)), m);
    EXPECT_FALSE(cost_measure_from_name("money"));
}

TEST(LiveCost, EstimatesAreHollowAndThePresentOneIsRinged) {
    const Plot plot = live_cost_plot(runs(), CostMeasure::seconds, Theme::dark);
    for (const PlotMark &m : plot.curves[0].marks) {
        EXPECT_FALSE(m.hollow);
        EXPECT_EQ(m.ringed, m.y == 0.1) << "position 6 is iteration 2";
    }
    for (const PlotMark &m : plot.curves[1].marks)
        EXPECT_TRUE(m.hollow);
}

TEST(LiveCost, EarlierRunsAreFaintNotJoinedAndHaveNoLabelOfTheirOwn) {
    const Plot plot = live_cost_plot(runs(), CostMeasure::seconds, Theme::dark);
    EXPECT_EQ(plot.curves[0].label, "(a) uniform, constant");
    EXPECT_EQ(plot.curves[1].label, "(d) cut, M = 4");
    EXPECT_EQ(plot.curves[2].label, "");
    EXPECT_TRUE(plot.curves[0].joined);
    EXPECT_FALSE(plot.curves[2].joined);
    EXPECT_LT(plot.curves[2].colour.a, plot.curves[0].colour.a);
}

} // namespace
} // namespace penumbra
