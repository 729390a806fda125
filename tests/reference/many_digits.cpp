#include "reference/many_digits.h"

#include <boost/math/constants/constants.hpp>

#include <map>
#include <mutex>

namespace penumbra::reference {

namespace {

ExactRule make_rule(int n) {
    ExactRule rule;
    for (int i = 0; i < n; ++i) {
        // Tricomi's first guess on [-1, 1].
        Digits x = -cos(boost::math::constants::pi<Digits>() * (i + Digits(0.75)) / (n + Digits(0.5)));
        Digits slope = 1;
        for (int step = 0; step < 12; ++step) {
            Digits p = 1, before = 0;
            for (int k = 0; k < n; ++k) {
                const Digits next = ((2 * k + 1) * x * p - k * before) / (k + 1);
                before = p;
                p = next;
            }
            slope = n * (x * p - before) / (x * x - 1);
            x -= p / slope;
        }
        rule.points.push_back((1 + x) / 2);
        rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

} // namespace

const ExactRule &exact_gauss(int n) {
    static std::mutex mutex;
    static std::map<int, ExactRule> rules;
    const std::scoped_lock lock(mutex);
    const auto found = rules.find(n);
    return found != rules.end() ? found->second : rules.emplace(n, make_rule(n)).first->second;
}

ExactPolynomial operator*(const ExactPolynomial &a, const ExactPolynomial &b) {
    ExactPolynomial out(a.size() + b.size() - 1, Digits(0));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            out[i + j] += a[i] * b[j];
    return out;
}

std::array<ExactPolynomial, 4> exact_legendre(const Digits &a, const Digits &b) {
    // With y = 2 (a + b u) - 1: y, (3 y^2 - 1) / 2 and (5 y^3 - 3 y) / 2.
    static const Digits root3 = sqrt(Digits(3)), root5 = sqrt(Digits(5)), root7 = sqrt(Digits(7));
    const ExactPolynomial y{2 * a - 1, 2 * b}, y2 = y * y, y3 = y2 * y;
    std::array<ExactPolynomial, 4> out{ExactPolynomial{Digits(1)}, y, y2, y3};
    for (Digits &c : out[1])
        c *= root3;
    for (Digits &c : out[2])
        c *= root5 * 3 / 2;
    out[2][0] -= root5 / 2;
    for (std::size_t i = 0; i < 4; ++i)
        out[3][i] = root7 * (5 * y3[i] - (i < 2 ? Digits(3 * y[i]) : Digits(0))) / 2;
    return out;
}

} // namespace penumbra::reference
