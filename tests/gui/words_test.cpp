// Numbers as the panels print them.
#include "panels/accuracy_words.h"
#include "panels/filter_words.h"
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

TEST(Words, Memory) {
    EXPECT_EQ(memory_words(0), "0 KiB");
    EXPECT_EQ(memory_words(740 * 1024.), "740 KiB");
    EXPECT_EQ(memory_words(12.34 * 1024 * 1024), "12.3 MiB");
    EXPECT_EQ(memory_words(1.5 * 1024 * 1024 * 1024), "1.5 GiB");
}

TEST(Words, WhereASolutionStandsWithTheAccuracy) {
    Snapshot s;
    EXPECT_EQ(accuracy_words(s), "");
    s.options.tolerance = 0.01;
    s.counters.iteration = 2;
    EXPECT_EQ(accuracy_words(s).find("On the way to 1 %: the error is measured"), 0U);
    s.counters.estimated_error = 0.02;
    EXPECT_EQ(accuracy_words(s), "Above the 1 % asked for: refinement goes on.");
    s.counters.exhausted = true;
    EXPECT_EQ(accuracy_words(s).find("The 1 % asked for is out of reach"), 0U);
    s.counters.converged = true;
    EXPECT_EQ(accuracy_words(s), "The 1 % asked for is reached.");
}

TEST(Words, FunctionsOfBothBases) {
    SplitFilters f;
    f.order = 4;
    EXPECT_EQ(function_words(f, 0, false), "L₀(u) L₀(v)");
    EXPECT_EQ(function_words(f, 9, true), "L₂(u′) L₁(v′)");
    f.basis = BasisFamily::planar;
    EXPECT_EQ(function_words(f, 0, false), "1");
    EXPECT_EQ(function_words(f, 7, true), "x²y + …");
}

TEST(Words, TheVerdictFollowsTheNumbers) {
    SplitFilters f;
    f.loss = Eigen::MatrixXd::Zero(4, 4);
    f.pieces.push_back({});
    f.pieces[0].difference = Eigen::MatrixXd::Zero(4, 4);
    EXPECT_NE(verdict(f).find("is constant"), std::string::npos);
    f.basis = BasisFamily::planar;
    EXPECT_NE(verdict(f).find("for every cut"), std::string::npos);
    f.loss(3, 2) = -0.11;
    EXPECT_NE(verdict(f).find("by up to 0.11."), std::string::npos) << verdict(f);
}

} // namespace
} // namespace penumbra
