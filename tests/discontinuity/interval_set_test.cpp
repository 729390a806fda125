// Unions and differences of intervals.
#include "discontinuity/interval_set.h"

#include <gmock/gmock.h>
#include <utility>

namespace penumbra {
namespace {

std::vector<std::pair<double, double>> list(const IntervalSet &set) {
    std::vector<std::pair<double, double>> all;
    for (const Interval &i : set.intervals())
        all.emplace_back(i.low, i.high);
    return all;
}

using ::testing::ElementsAre;
using ::testing::Pair;

TEST(IntervalSet, UnitesWhatOverlapsOrTouches) {
    IntervalSet set(Interval{2, 3});
    set.unite({0, 1});
    set.unite({5, 6});
    EXPECT_THAT(list(set), ElementsAre(Pair(0, 1), Pair(2, 3), Pair(5, 6)));
    set.unite({1, 2});
    EXPECT_THAT(list(set), ElementsAre(Pair(0, 3), Pair(5, 6)));
    set.unite({3.5, 4.75}, 0.25);
    EXPECT_THAT(list(set), ElementsAre(Pair(0, 3), Pair(3.5, 6)));
    set.unite({7, 7});
    EXPECT_THAT(list(set), ElementsAre(Pair(0, 3), Pair(3.5, 6)));
}

TEST(IntervalSet, SubtractsClipsAndSplits) {
    IntervalSet set(Interval{0, 10});
    set.subtract({2, 3});
    set.subtract({9, 20});
    set.subtract({5, 5});
    EXPECT_THAT(list(set), ElementsAre(Pair(0, 2), Pair(3, 9)));
    set.split(4);
    set.split(2.5);
    EXPECT_THAT(list(set), ElementsAre(Pair(0, 2), Pair(3, 4), Pair(4, 9)));
    IntervalSet other(Interval{1, 3.5});
    other.unite({8, 12});
    set.clip(other);
    EXPECT_THAT(list(set), ElementsAre(Pair(1, 2), Pair(3, 3.5), Pair(8, 9)));
    set.drop_shorter(0.75);
    EXPECT_THAT(list(set), ElementsAre(Pair(1, 2), Pair(8, 9)));
}

} // namespace
} // namespace penumbra
