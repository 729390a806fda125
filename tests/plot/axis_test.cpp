// Axes: ranges, ticks and their words.
#include "plot/log_axis.h"

#include <gmock/gmock.h>

#include <cmath>

namespace penumbra {
namespace {

using testing::ElementsAre;

std::vector<std::string> labels(const LogAxis &axis, int most = 6) {
    std::vector<std::string> all;
    for (const Tick &t : ticks(axis, most))
        if (!t.label.empty())
            all.push_back(t.label);
    return all;
}

TEST(LogAxis, PlacesDecadesEvenly) {
    const LogAxis axis{1, 1000, PlotUnit::count};
    EXPECT_DOUBLE_EQ(axis.place(1), 0);
    EXPECT_DOUBLE_EQ(axis.place(10), 1. / 3);
    EXPECT_DOUBLE_EQ(axis.place(1000), 1);
    EXPECT_DOUBLE_EQ(axis.place(0.1), -1. / 3) << "beyond the low end";
}

TEST(LogAxis, TicksAreAllDigitsOfEachDecade) {
    // 8, 9 of the first decade, 1 to 9 of the next, 1 to 3 of the last.
    const auto all = ticks({7.5, 350, PlotUnit::count});
    std::vector<double> values;
    for (const Tick &t : all)
        values.push_back(std::round(t.value));
    EXPECT_THAT(values, ElementsAre(8, 9, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 200, 300));
    for (const Tick &t : all)
        EXPECT_EQ(t.major, std::abs(t.value - 10) < 1e-6 || std::abs(t.value - 100) < 1e-6) << t.value;
}

TEST(LogAxis, EndsThatAreTicksAreShown) {
    EXPECT_THAT(labels({1e-3, 1, PlotUnit::share}), ElementsAre("0.1 %", "1 %", "10 %", "100 %"));
}

TEST(LogAxis, WhereTwoDecadesOrFewerAreLabelledTwosAndFivesAre) {
    EXPECT_THAT(labels({15, 80, PlotUnit::count}), ElementsAre("20", "50"));
    EXPECT_THAT(labels({4, 60, PlotUnit::count}), ElementsAre("5", "10", "20", "50"));
    EXPECT_THAT(labels({4, 6000, PlotUnit::count}), ElementsAre("10", "100", "1000"));
    EXPECT_THAT(labels({4, 60, PlotUnit::count}, 3), ElementsAre("10")) << "where there is room";
}

TEST(LogAxis, ManyDecadesAreThinnedOut) {
    // 9 decades, at most 4 labels: every third power that 3 divides.
    EXPECT_THAT(labels({1, 1e8, PlotUnit::count}, 4), ElementsAre("1", "1000", "10\u2076"));
    EXPECT_EQ(labels({1, 1e8, PlotUnit::count}, 9).size(), 9U);
}

TEST(TickWords, AreWhatPeopleWrite) {
    EXPECT_EQ(tick_words(1, PlotUnit::count), "1");
    EXPECT_EQ(tick_words(5000, PlotUnit::count), "5000");
    EXPECT_EQ(tick_words(1e4, PlotUnit::count), "10\u2074");
    EXPECT_EQ(tick_words(2e5, PlotUnit::count), "2\u00b710\u2075");
    EXPECT_EQ(tick_words(1e12, PlotUnit::count), "10\u00b9\u00b2");
    EXPECT_EQ(tick_words(1e-6, PlotUnit::seconds), "1 \u00b5s");
    EXPECT_EQ(tick_words(1e-3, PlotUnit::seconds), "1 ms");
    EXPECT_EQ(tick_words(0.05, PlotUnit::seconds), "50 ms");
    EXPECT_EQ(tick_words(1, PlotUnit::seconds), "1 s");
    EXPECT_EQ(tick_words(200, PlotUnit::seconds), "200 s");
    EXPECT_EQ(tick_words(1, PlotUnit::share), "100 %");
    EXPECT_EQ(tick_words(2e-4, PlotUnit::share), "0.02 %");
    EXPECT_EQ(tick_words(1e-5, PlotUnit::share), "0.001 %");
    EXPECT_EQ(tick_words(5e-7, PlotUnit::share), "5\u00b710\u207b\u2075 %");
}

TEST(TickWords, OfEveryTickHasOneDigitThatIsRight) {
    for (const Tick &t : ticks({1e-9, 1e9, PlotUnit::count}, 100)) {
        if (t.label.empty())
            continue;
        const int power = static_cast<int>(std::lround(std::log10(t.value)));
        const bool decimal = power >= -3 && power <= 3;
        EXPECT_DOUBLE_EQ(std::stod(t.label), decimal ? std::pow(10, power) : 10) << t.label;
    }
}

TEST(AxisRange, HasAMarginOnBothSides) {
    AxisRange range;
    for (const double x : {1e-2, 1., 1e2})
        range.add(x);
    const LogAxis axis = range.axis(PlotUnit::count);
    EXPECT_NEAR(std::log10(axis.low), -2 - 0.06 * 4, 1e-12);
    EXPECT_NEAR(std::log10(axis.high), 2 + 0.06 * 4, 1e-12);
}

TEST(AxisRange, IsADecadeLongAtLeastAboutWhatItShows) {
    AxisRange range;
    range.add(5);
    const LogAxis axis = range.axis(PlotUnit::count);
    EXPECT_NEAR(axis.high / axis.low, 10, 1e-9);
    EXPECT_NEAR(axis.place(5), 0.5, 1e-12);
}

TEST(AxisRange, LeavesOutWhatALogarithmCannotShow) {
    AxisRange range;
    for (const double x : {0., -1., std::numeric_limits<double>::infinity(), std::nan("")})
        range.add(x);
    EXPECT_EQ(range.axis(PlotUnit::seconds).low, 1);
    EXPECT_EQ(range.axis(PlotUnit::seconds).high, 10);
    range.add(3);
    range.add(300);
    EXPECT_NEAR(range.axis(PlotUnit::seconds).place(30), 0.5, 1e-12) << "as if the others had not been there";
}

} // namespace
} // namespace penumbra
