// The table beside the paper's figures: its bars show that patches are not work.
#include "files/paper_table.h"

#include <gmock/gmock.h>

#include <memory>

namespace penumbra {
namespace {

using testing::HasSubstr;

/// (c) has half of (a)'s patches and four times its seconds.
Solutions two() {
    Snapshot a, c;
    a.options.strategy = Strategy::uniform_constant;
    a.counters.patches = 100;
    a.counters.coefficients = 100;
    a.counters.link_coefficients = 1000;
    a.counters.seconds = 0.5;
    c.options.strategy = Strategy::uniform_wavelet;
    c.counters.patches = 50;
    c.counters.coefficients = 800;
    c.counters.link_coefficients = 8000;
    c.counters.seconds = 2;
    return {std::make_shared<Snapshot>(a), std::make_shared<Snapshot>(c)};
}

std::string blocks(int n) {
    std::string text;
    for (int i = 0; i < n; ++i)
        text += "\u2588";
    return text;
}

TEST(PaperTable, BarsAreSharesOfTheLongestInTheirColumn) {
    const std::string text = work_bars(two());
    const std::string a = text.substr(text.find("(a)"), text.find("(c)") - text.find("(a)")),
                      c = text.substr(text.find("(c)"));
    EXPECT_THAT(a, HasSubstr(" " + blocks(11) + " 100 "));
    EXPECT_THAT(c, HasSubstr(" " + blocks(6) + " 50 ")); // 11 / 2, rounded
    EXPECT_THAT(c, HasSubstr(" " + blocks(11) + " 800 "));
    EXPECT_THAT(a, HasSubstr(" " + blocks(1) + " 100 ")) << "100 of 800 functions";
    EXPECT_THAT(a, HasSubstr(" " + blocks(1) + " 1000 "));
    EXPECT_THAT(a, HasSubstr(" " + blocks(3) + " 0.500")); // 11 / 4
    EXPECT_THAT(c, HasSubstr(" " + blocks(11) + " 2.000"));
    EXPECT_THAT(paper_text(two()), HasSubstr(text));
}

TEST(PaperTable, TheCsvHasTheLinksCoefficients) {
    const std::string csv = paper_csv(two());
    EXPECT_THAT(csv, HasSubstr(",max_depth,link_coefficients\n"));
    EXPECT_THAT(csv, HasSubstr(",8000\n"));
}

} // namespace
} // namespace penumbra
