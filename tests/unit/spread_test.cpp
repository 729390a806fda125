// Medians and spreads of repeated measurements; the processor's name.
#include "core/machine.h"
#include "study/spread.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

TEST(Spread, OfAnOddNumberIsTheOneInTheMiddle) {
    const Spread s = spread_of({5, 1, 100});
    EXPECT_EQ(s.median, 5) << "not the mean, 35.3, which one slow run spoils";
    EXPECT_EQ(s.low, 1);
    EXPECT_EQ(s.high, 100);
}

TEST(Spread, OfAnEvenNumberIsTheMeanOfTheTwoInTheMiddle) { EXPECT_EQ(spread_of({8, 1, 2, 4}).median, 3); }

TEST(Spread, OfOneAndOfNone) {
    EXPECT_EQ(spread_of({7}).median, 7);
    EXPECT_EQ(spread_of({7}).low, 7);
    EXPECT_EQ(spread_of({7}).high, 7);
    EXPECT_EQ(spread_of({}).median, 0);
}

TEST(Machine, TheProcessorsNameOutOfTheSystemsText) {
    EXPECT_EQ(cpu_model_in("processor\t: 0\nmodel\t\t: 106\nmodel name\t: Some(R)   CPU @ 2.00GHz\nprocessor\t: 1\n"
                           "model name\t: Another\n"),
              "Some(R) CPU @ 2.00GHz");
    EXPECT_EQ(cpu_model_in("processor\t: 0\nHardware\t: BCM2835\nModel\t\t: A board, revision 1.4\n"),
              "A board, revision 1.4");
    EXPECT_EQ(cpu_model_in("model number : 3\n"), "");
    EXPECT_EQ(cpu_model_in(""), "");
    EXPECT_GE(n_cores(), 1);
}

} // namespace
} // namespace penumbra
