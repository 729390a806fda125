// Numbers as the panels print them.
#include "panels/words.h"

#include <gtest/gtest.h>

#include <limits>

namespace penumbra {
namespace {

TEST(Words, PowersOfTen) {
    EXPECT_EQ(power_words(0), "0");
    EXPECT_EQ(power_words(0.25), "0.25");
    EXPECT_EQ(power_words(-0.5), "−0.5");
    EXPECT_EQ(power_words(3.794e-5), "3.79·10⁻⁵");
    EXPECT_EQ(power_words(-2.22e-16, 2), "−2.2·10⁻¹⁶");
    EXPECT_EQ(power_words(1e21), "1·10²¹");
    EXPECT_EQ(power_words(std::numeric_limits<double>::infinity()), "inf");
    EXPECT_EQ(power_words(std::numeric_limits<double>::quiet_NaN()), "nan");
}

} // namespace
} // namespace penumbra
