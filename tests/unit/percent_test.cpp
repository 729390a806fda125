// Shares as people write them.
#include "core/percent.h"

#include <gtest/gtest.h>

#include <limits>

namespace penumbra {
namespace {

TEST(Percent, TwoDigitsAndAllBeforeThePoint) {
    EXPECT_EQ(percent(1), "100 %");
    EXPECT_EQ(percent(0.996), "100 %");
    EXPECT_EQ(percent(12.34), "1234 %");
    EXPECT_EQ(percent(0.0996), "10 %");
    EXPECT_EQ(percent(0.045), "4.5 %");
    EXPECT_EQ(percent(0.02), "2 %");
    EXPECT_EQ(percent(0.00031), "0.031 %");
    EXPECT_EQ(percent(-0.5), "-50 %");
    EXPECT_EQ(percent(0), "0 %");
}

TEST(Percent, WhatIsNoNumberIsNamed) {
    EXPECT_EQ(percent(std::numeric_limits<double>::infinity()), "inf %");
    EXPECT_EQ(percent(1e300).find('e'), std::string::npos);
}

} // namespace
} // namespace penumbra
