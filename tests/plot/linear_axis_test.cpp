// Linear axes: ranges, ticks and their words.
#include "plot/linear_axis.h"

#include <gmock/gmock.h>

namespace penumbra {
namespace {

using testing::ElementsAre;

std::vector<std::string> labels(const LinearAxis &axis, int most = 6) {
    std::vector<std::string> all;
    for (const Tick &t : ticks(axis, most))
        if (!t.label.empty())
            all.push_back(t.label);
    return all;
}

TEST(LinearAxis, PlacesAndTheReverse) {
    const LinearAxis axis{-1, 3};
    EXPECT_DOUBLE_EQ(axis.place(0), 0.25);
    EXPECT_DOUBLE_EQ(axis.value(0.25), 0);
    EXPECT_DOUBLE_EQ(axis.place(4), 1.25) << "beyond the high end";
}

TEST(LinearAxis, LabelsStandAtRoundNumbersAndAreNoMoreThanAskedFor) {
    EXPECT_THAT(labels({0, 1}), ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1.0"));
    EXPECT_THAT(labels({-0.03, 0.03}, 3), ElementsAre("\u22120.02", "0", "0.02"));
    EXPECT_THAT(labels({0.2, 13}, 4), ElementsAre("5", "10"));
    EXPECT_THAT(labels({0, 3e6}, 3), ElementsAre("0", "1e+06", "2e+06", "3e+06"));
    for (const double length : {0.37, 1.0, 1.9, 4.2, 8.8})
        for (const int most : {2, 4, 7}) {
            const auto n = labels({0.1, 0.1 + length}, most).size();
            EXPECT_GE(n, 1u) << length << " " << most;
            EXPECT_LE(n, static_cast<std::size_t>(most) + 1) << length << " " << most;
        }
}

TEST(LinearAxis, UnlabelledTicksDivideTheSteps) {
    int minor = 0;
    for (const Tick &t : ticks(LinearAxis{0, 1}, 6)) {
        EXPECT_EQ(t.major, !t.label.empty());
        minor += !t.major;
    }
    EXPECT_EQ(minor, 5) << "one between two: a step of 0.2 has halves";
}

TEST(LinearAxis, RangesHoldWhatIsFiniteWithAMargin) {
    const LinearAxis axis = linear_axis({3, 1, 1.0 / 0.0, 2}, 0.1);
    EXPECT_NEAR(axis.low, 0.8, 1e-12);
    EXPECT_NEAR(axis.high, 3.2, 1e-12);
    EXPECT_LT(linear_axis({5, 5}, 0.1).low, 5);
    EXPECT_GT(linear_axis({5, 5}, 0.1).high, 5);
    EXPECT_LT(linear_axis({0}, 0.1).low, 0);
    EXPECT_LT(linear_axis({}, 0.1).low, linear_axis({}, 0.1).high);
}

} // namespace
} // namespace penumbra
