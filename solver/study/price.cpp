#include "study/price.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace penumbra {

namespace {

/// Of a price's logarithm: of time on a busy machine, of patches from step to step. On the way to a smaller error a run has paid
/// for attempts as well, so that its prices rise faster than those of whole runs, and say less of the next one.
double scatter(const PricePaid &p) { return p.on_the_way ? 0.6 : 0.3; }

/// Logarithm of 1/error, and of one part of the price at it; weight: 1 / its variance.
struct Sample {
    double x, y, weight;
};
using Samples = std::vector<Sample>;

/// By x; of one and the same x their mean, which weighs as much as the surest of them.
Samples in_order(Samples samples) {
    std::ranges::sort(samples, {}, &Sample::x);
    Samples out;
    for (std::size_t i = 0; i < samples.size();) {
        double sum = 0, weights = 0, most = 0;
        std::size_t j = i;
        for (; j < samples.size() && samples[j].x <= samples[i].x + 1e-9; ++j) {
            sum += samples[j].weight * samples[j].y;
            weights += samples[j].weight;
            most = std::max(most, samples[j].weight);
        }
        out.push_back({samples[i].x, sum / weights, most});
        i = j;
    }
    return out;
}

double fitted_exponent(const Samples &samples, double usual, double spread) {
    double weights = 0, x = 0, y = 0;
    for (const Sample &s : samples) {
        weights += s.weight;
        x += s.weight * s.x;
        y += s.weight * s.y;
    }
    x /= weights;
    y /= weights;
    double xx = 0, xy = 0;
    for (const Sample &s : samples) {
        xx += s.weight * (s.x - x) * (s.x - x);
        xy += s.weight * (s.x - x) * (s.y - y);
    }
    const double prior = 1 / (spread * spread);
    return std::max(0.0, (xy + usual * prior) / (xx + prior));
}

double predicted(const Samples &samples, double exponent, double x) {
    const auto after = std::ranges::lower_bound(samples, x, {}, &Sample::x);
    if (after == samples.begin() || after == samples.end()) {
        const Sample &nearest = after == samples.end() ? samples.back() : samples.front();
        return nearest.y + exponent * (x - nearest.x);
    }
    const Sample &a = *(after - 1), &b = *after;
    return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

/// On the way to a tolerance links are made for this threshold or a smaller one.
double links_threshold(double tolerance) { return 2 * tolerance; }

} // namespace

std::optional<PricePaid> price_paid(const Options &options, const Counters &c, double true_error) {
    PricePaid paid{c.error_limit, c.threshold, {c.seconds, static_cast<double>(c.link_bytes), static_cast<double>(c.patches)}};
    if (options.tolerance) {
        paid.threshold = links_threshold(*options.tolerance);
        paid.on_the_way = !c.converged;
    } else
        paid.error = c.settled ? true_error : 0;
    if (!(paid.error > 0 && c.seconds > 0))
        return std::nullopt;
    return paid;
}

std::optional<Price> predict_price(std::span<const PricePaid> paid, const PriceGrowth &usual, double tolerance) {
    if (paid.empty() || !(tolerance > 0))
        return std::nullopt;
    const auto log_fine_links = [&](double threshold) {
        return threshold < fine_threshold ? std::log(usual.fine_links) : 0;
    };
    const auto part = [&](double Price::*of, double exponent, bool with_fine_links) {
        Samples samples;
        for (const PricePaid &p : paid)
            samples.push_back({-std::log(p.error), std::log(std::max(p.price.*of, 1e-9)) -
                                                       (with_fine_links ? log_fine_links(p.threshold) : 0),
                               1 / (scatter(p) * scatter(p))});
        samples = in_order(std::move(samples));
        const double y = predicted(samples, fitted_exponent(samples, exponent, usual.spread), -std::log(used_up * tolerance));
        return std::exp(y + (with_fine_links ? log_fine_links(links_threshold(tolerance)) : 0));
    };
    return Price{part(&Price::seconds, usual.seconds, true), part(&Price::bytes, usual.bytes, false),
                 part(&Price::patches, usual.patches, false)};
}

PriceGrowth usual_growth(const Options &options, bool one_bounce) {
    // By order, then uniform or cut, then reflected again or one bounce: seconds, bytes, patches.
    using Exponents = std::array<double, 3>;
    static constexpr Exponents measured[4][2][2]{
        {{{1.5, 2.9, 2.0}, {2.0, 2.0, 2.0}}, {{1.5, 2.9, 2.0}, {1.3, 2.0, 2.0}}},
        {{{0.7, 1.5, 1.05}, {1.0, 1.3, 1.3}}, {{0.73, 1.4, 1.05}, {0.42, 1.0, 1.0}}},
        {{{0.5, 0.95, 0.65}, {0.57, 1.2, 1.2}}, {{0.8, 1.15, 0.9}, {0.35, 0.8, 0.8}}}, // uniform: order 4's
        {{{0.5, 0.95, 0.65}, {0.57, 1.2, 1.2}}, {{0.65, 1.1, 0.75}, {0.2, 0.7, 0.7}}}};
    const int order = options.effective_order();
    const Exponents &e = measured[order - 1][cuts_along_curves(options.strategy)][one_bounce];
    PriceGrowth growth{.seconds = e[0], .bytes = e[1], .patches = e[2]};
    if (order > 1 && !one_bounce)
        growth.fine_links = 4.8; // measured at order 4
    return growth;
}

} // namespace penumbra
