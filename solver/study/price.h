// What an accuracy will cost, from what has been measured on this scene so far.
#pragma once

#include "core/counters.h"
#include "core/options.h"

#include <optional>
#include <span>

namespace penumbra {

/// What a solution takes from nothing to the end.
struct Price {
    double seconds = 0; ///< of all iterations, with the measuring of the error
    double bytes = 0;   ///< of the links at the end
    double patches = 0; ///< at the end
};

/// A price that was paid, at the end or on the way.
struct PricePaid {
    double error = 0;     ///< relative L2: its upper limit, as measured, or the true one
    double threshold = 1; ///< that its links were made for (Setting::transport)
    Price price;
    bool on_the_way = false; ///< not what a whole run to that error costs: what a run to a smaller one had spent by then
};

/// Of a state in a run to a tolerance; nothing where its error was not measured. In a run to a threshold: of a settled state
/// whose true error is known.
std::optional<PricePaid> price_paid(const Options &options, const Counters &counters, double true_error = -1);

/// Error's upper limit over the tolerance where a solution ends: it falls in leaps (tests/bench/README.md).
inline constexpr double used_up = 0.7;

/// How prices grow, price ~ error^-exponent, with what is known of it before anything was measured on the scene.
struct PriceGrowth {
    double seconds = 0, bytes = 0, patches = 0; ///< exponents
    double spread = 0.3;  ///< standard deviation of the exponents from scene to scene
    double fine_links = 1; ///< by how much seconds rise where links are made for a threshold below fine_threshold
};

/// Links are made with more points below this threshold (Transport::accuracy), which weighs where light is reflected again.
inline constexpr double fine_threshold = 3.16e-3;

/// Measured on the bundled scenes, by strategy and order, where light bounces once and where it is reflected again
/// (tests/bench/README.md, "What the next digit costs").
PriceGrowth usual_growth(const Options &options, bool one_bounce);

/// Price for the tolerance, of which solutions use up `used_up` on the average. Between two errors whose price was paid: on a straight line in logarithms. Beyond: from the
/// nearest one with an exponent that balances the usual one with least squares through all that was paid (a normal prior of
/// the usual exponent and its spread; logarithms of prices scatter by 0.3, on the way by 0.6), so that a single price is enough. Nothing
/// without one.
std::optional<Price> predict_price(std::span<const PricePaid> paid, const PriceGrowth &usual, double tolerance);

} // namespace penumbra
