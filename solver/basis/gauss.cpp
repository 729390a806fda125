#include "basis/gauss.h"

#include "core/check.h"

#include <array>
#include <cmath>
#include <numbers>

namespace penumbra {

namespace {

constexpr int most = 64;

GaussRule compute(int n) {
    GaussRule rule{std::vector<double>(static_cast<std::size_t>(n)), std::vector<double>(static_cast<std::size_t>(n))};
    for (int k = 0; k < n; ++k) {
        double x = -std::cos(std::numbers::pi * (k + 0.75) / (n + 0.5)), slope = 1;
        for (int sweep = 0; sweep < 100; ++sweep) {
            double p = 1, before = 0;
            for (int j = 0; j < n; ++j) {
                const double next = ((2 * j + 1) * x * p - j * before) / (j + 1);
                before = p;
                p = next;
            }
            slope = n * (x * p - before) / (x * x - 1);
            const double dx = p / slope;
            x -= dx;
            if (std::abs(dx) < 1e-16)
                break;
        }
        rule.points[static_cast<std::size_t>(k)] = (1 + x) / 2;
        rule.weights[static_cast<std::size_t>(k)] = 1 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

} // namespace

const GaussRule &gauss_rule(int n) {
    static const std::array<GaussRule, most + 1> rules = [] {
        std::array<GaussRule, most + 1> all;
        for (int i = 1; i <= most; ++i)
            all[static_cast<std::size_t>(i)] = compute(i);
        return all;
    }();
    PENUMBRA_CHECK(n, >=, 1);
    PENUMBRA_CHECK(n, <=, most);
    return rules[static_cast<std::size_t>(n)];
}

} // namespace penumbra
