// Tests over both bases and all strategies.
#pragma once

#include "core/options.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

namespace penumbra {

using BasisAndStrategy = std::tuple<BasisFamily, Strategy>;

inline auto every_basis_and_strategy() {
    return testing::Combine(testing::Values(BasisFamily::parametric, BasisFamily::planar), testing::ValuesIn(all_strategies));
}

/// "planar_uniform_constant"
inline std::string words_for(const testing::TestParamInfo<BasisAndStrategy> &at) {
    std::string words = std::string(name(std::get<0>(at.param))) + "_" + std::string(name(std::get<1>(at.param)));
    std::ranges::replace(words, '-', '_');
    return words;
}

} // namespace penumbra
