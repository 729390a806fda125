// cost.csv.
#include "files/cost_table.h"

#include <gmock/gmock.h>

#include <sstream>

namespace penumbra {
namespace {

std::vector<std::string> lines(const std::string &text) {
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        all.push_back(line);
    return all;
}

CostPoint point() {
    CostPoint p;
    p.options.strategy = Strategy::uniform_wavelet;
    p.options.basis = BasisFamily::planar;
    p.options.threshold = 0.002;
    p.options.max_depth = 12;
    p.end = RunEnd::done;
    p.seconds = {0.5, 0.25, 4};
    p.error = 0.00125;
    p.counters.iteration = 5;
    p.counters.patches = 7;
    p.counters.coefficients = 70;
    p.counters.links = 9;
    p.counters.total_work.kernel_evaluations = 12345678901;
    p.counters.total_work.clips = 11;
    p.counters.nodes_at_limit = 2;
    return p;
}

TEST(CostCsv, IsALineForEachPoint) {
    const CostStudy study{"a scene", "CPU 9", 8, 4, "1.2.3", 3, {}, {point()}};
    const auto csv = lines(cost_csv(study));
    ASSERT_EQ(csv.size(), 2U);
    EXPECT_EQ(csv[0], "strategy,basis,order,threshold,max_depth,status,runs,seconds,seconds_min,seconds_max,patches,"
                      "coefficients,links,kernel_evaluations,error,iterations,clips,nodes_at_limit,scene,cpu,cores,threads,"
                      "version,reference_error");
    EXPECT_EQ(csv[1], "uniform-wavelet,planar,4,0.002,12,done,3,0.5,0.25,4,7,70,9,12345678901,0.00125,5,11,2,a scene,"
                      "CPU 9,8,4,1.2.3,0");
}

TEST(CostCsv, WhatIsNotKnownIsEmptyAndAllLinesHaveAllFields) {
    CostPoint stopped = point(), untried = point(), nothing = point();
    stopped.end = RunEnd::time_limit;
    stopped.seconds = {2.5};
    untried.end = RunEnd::not_tried;
    untried.seconds.clear();
    untried.counters = {};
    untried.error = -1;
    nothing.end = RunEnd::failed;
    nothing.counters = {};
    nothing.error = -1;
    nothing.seconds = {0.125};
    const auto csv = lines(cost_csv({"s", "", 1, 1, "", 3, {}, {stopped, untried, nothing}}));
    ASSERT_EQ(csv.size(), 4U);
    for (const std::string &line : csv)
        EXPECT_EQ(std::ranges::count(line, ','), 23) << line;
    EXPECT_THAT(csv[1], testing::HasSubstr(",time limit,0,2.5,2.5,2.5,7,"));
    EXPECT_THAT(csv[2], testing::HasSubstr(",not tried,0,,,,,,,,,,,,s,,1,1,"));
    EXPECT_THAT(csv[3], testing::HasSubstr(",failed,0,0.125,0.125,0.125,,,,,,,,,s,,1,1,"));
}

TEST(CostCsv, NamesWithCommasAndQuotationMarksAreQuoted) {
    const auto csv = lines(cost_csv({"a,b \"c\"", "X, 2 GHz", 1, 1, "", 1, {}, {point()}}));
    EXPECT_THAT(csv[1], testing::HasSubstr(",\"a,b \"\"c\"\"\",\"X, 2 GHz\",1,1,"));
}

TEST(CostCsv, ConstantStrategiesHaveOrderOne) {
    CostPoint p = point();
    p.options.strategy = Strategy::discontinuity_constant;
    EXPECT_THAT(lines(cost_csv({"s", "", 1, 1, "", 1, {}, {p}}))[1],
                testing::StartsWith("discontinuity-constant,planar,1,"));
}

} // namespace
} // namespace penumbra
