// The shelf of hard cases, each in both bases; and that a case can fail.
#include "study/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <tuple>

namespace penumbra {
namespace {

std::string label(const std::tuple<int, BasisFamily> &chosen) {
    std::string text = hard_cases()[static_cast<std::size_t>(std::get<0>(chosen))].name;
    std::ranges::replace_if(
        text, [](char c) { return c == '-' || c == '.'; }, '_');
    return text + "_" + std::string(name(std::get<1>(chosen)));
}

class HardCases : public testing::TestWithParam<std::tuple<int, BasisFamily>> {};

/// Cases whose largest error at some point is beyond the threshold, today: the oracle looks at points of its own, and
/// between them a misfit may be larger. `penumbra check` calls them FAILED and exits with 1. All else that is asked of
/// them holds; a case that comes to hold its bound, too, must be taken off this list.
const std::set<std::string> missing_their_bound{"edge_1_degree_planar", "t_junctions_planar", "blocker_piercing_planar",
                                                "two_blockers_in_one_plane_parametric"};

TEST_P(HardCases, Hold) {
    const auto &[index, basis] = GetParam();
    const CaseResult result = examine(hard_cases()[static_cast<std::size_t>(index)], basis);
    ASSERT_FALSE(result.measurements.empty()) << result.what;
    const bool missing = missing_their_bound.contains(label(GetParam()));
    for (const Measurement &m : result.measurements)
        if (!missing || !m.quantity.starts_with("error against")) {
            EXPECT_LE(m.value, m.bound) << m.quantity;
        }
    EXPECT_EQ(result.holds(), !missing) << result.what;
}

INSTANTIATE_TEST_SUITE_P(Shelf, HardCases,
                         testing::Combine(testing::Range(0, static_cast<int>(hard_cases().size())),
                                          testing::Values(BasisFamily::parametric, BasisFamily::planar)),
                         [](const auto &chosen) { return label(chosen.param); });

TEST(HardCase, NamesAreUnique) {
    std::set<std::string> names;
    for (const HardCase &hard_case : hard_cases())
        EXPECT_TRUE(names.insert(hard_case.name).second) << hard_case.name;
}

TEST(HardCase, AnImpossibleBoundFails) {
    // A peak that may be less than nothing, alone and between cases that hold; a value that is no number; and nothing
    // measured at all.
    const HardCase impossible{"impossible", "", [](const TrialSetting &setting) {
                                  const Trial trial = solve(room(Vec3(1, 1, 1), 0.5, 1), setting);
                                  return std::vector<Measurement>{{"peak", trial.state->peak, -1}};
                              }};
    const CaseResult failed = examine(impossible, BasisFamily::parametric);
    EXPECT_FALSE(failed.holds());
    const CaseResult held{"held", "", BasisFamily::parametric, {{"nothing", 0, 0}}};
    EXPECT_TRUE(all_hold({held, held}));
    EXPECT_FALSE(all_hold({held, failed, held}));
    EXPECT_FALSE(all_hold({}));
    EXPECT_FALSE((Measurement{"lost", std::numeric_limits<double>::quiet_NaN(), 1}.holds()));
    EXPECT_FALSE(CaseResult().holds());
}

} // namespace
} // namespace penumbra
