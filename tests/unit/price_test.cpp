// Prices predicted from prices paid: power laws come back, one price is enough, and nothing is made of nothing.
#include "study/price.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace penumbra {
namespace {

constexpr PriceGrowth usual{.seconds = 2, .bytes = 1, .patches = 0.5, .spread = 0.3, .fine_links = 1};

/// The tolerance for which solutions end with this error.
double for_error(double error) { return error / used_up; }

PricePaid paid(double error, double seconds, double threshold = 1) {
    return {error, threshold, {seconds, 1000 * seconds, 10 * seconds}};
}

TEST(Price, IsNotKnownBeforeAnythingWasPaid) {
    EXPECT_FALSE(predict_price({}, usual, 0.01));
    const std::vector<PricePaid> one{paid(0.1, 1)};
    EXPECT_FALSE(predict_price(one, usual, 0));
}

TEST(Price, OfOnePaidGrowsAsUsual) {
    const std::vector<PricePaid> one{paid(0.1, 3)};
    const Price finer = *predict_price(one, usual, for_error(0.01));
    EXPECT_NEAR(finer.seconds, 3 * 100, 1e-9);          // 10^2
    EXPECT_NEAR(finer.bytes, 3000 * 10, 1e-6);          // 10^1
    EXPECT_NEAR(finer.patches, 30 * std::sqrt(10.), 1e-9); // 10^0.5
    EXPECT_NEAR(predict_price(one, usual, for_error(0.1))->seconds, 3, 1e-12) << "what was paid is what it costs";
    EXPECT_NEAR(predict_price(one, usual, for_error(1))->seconds, 0.03, 1e-12) << "and looser is cheaper by the same law";
}

TEST(Price, ManyPaidOutweighTheUsual) {
    // seconds = error^-0.7, over three decades; the usual 2 would be 6 times as much for a third of the error.
    std::vector<PricePaid> many;
    for (int i = 0; i <= 6; ++i)
        many.push_back(paid(std::pow(10, -0.5 * i), std::pow(10, 0.35 * i)));
    const double exact = std::pow(3e3, 0.7), said = predict_price(many, usual, for_error(1 / 3e3))->seconds;
    EXPECT_NEAR(said, exact, 0.05 * exact);
}

TEST(Price, OfFewIsBetweenTheUsualAndTheMeasured) {
    // Two a factor of e apart that did not differ: slope 0; prior N(2, 0.3), scatter 0.3. By hand: sum (x - mean)^2 = 1/2,
    // so that the exponent is 2 / (1 + 1/2).
    const std::vector<PricePaid> two{paid(1, 1), paid(std::exp(-1), 1)};
    EXPECT_NEAR(predict_price(two, usual, for_error(std::exp(-2)))->seconds, std::exp(2 / 1.5), 1e-9);
}

TEST(Price, OnTheWaySaysLessOfTheNextOne) {
    // As before, but the first was paid on the way, with scatter 0.6. By hand: weights 1 and 1/4 of 1/0.09, mean of x 4/5,
    // weighted sum of (x - mean)^2 1/5, so that the exponent is 2 / (1 + 1/5).
    std::vector<PricePaid> two{paid(1, 1), paid(std::exp(-1), 1)};
    two[0].on_the_way = true;
    EXPECT_NEAR(predict_price(two, usual, for_error(std::exp(-2)))->seconds, std::exp(2 / 1.2), 1e-9);
}

TEST(Price, BetweenTwoPaidIsOnTheLine) {
    const std::vector<PricePaid> two{paid(0.01, 16), paid(0.1, 1)};
    EXPECT_NEAR(predict_price(two, usual, for_error(std::sqrt(0.001)))->seconds, 4, 1e-9);
}

TEST(Price, NeverFallsWithTheErrorBeyondWhatWasPaid) {
    const std::vector<PricePaid> falling{paid(0.1, 100), paid(0.001, 1)};
    EXPECT_GE(predict_price(falling, usual, for_error(1e-4))->seconds, 1);
}

TEST(Price, OfFineLinksIsAddedOnceTheThresholdIsFine) {
    PriceGrowth fine = usual;
    fine.fine_links = 5;
    // Links are made for twice the tolerance. Exponent 2: half the error is four times as dear.
    const std::vector<PricePaid> one{paid(used_up * 0.004, 1, 0.008)};
    EXPECT_NEAR(predict_price(one, fine, 0.002)->seconds, 4, 1e-9) << "threshold 0.004";
    EXPECT_NEAR(predict_price(one, fine, 0.001)->seconds, 5 * 16, 1e-9) << "threshold 0.002";
    const std::vector<PricePaid> there{paid(used_up * 0.001, 1, 0.002)}; // paid already
    EXPECT_NEAR(predict_price(there, fine, 0.0001)->seconds, 100, 1e-9);
}

TEST(Price, IsPaidWhereTheErrorIsKnown) {
    Counters c;
    c.seconds = 2;
    c.patches = 7;
    c.link_bytes = 5;
    c.threshold = 0.03;
    const Options by_tolerance = Options().to_tolerance(0.01), by_threshold;
    EXPECT_FALSE(price_paid(by_tolerance, c)) << "not measured";
    c.error_limit = 0.02;
    c.estimated_error = 0.015;
    EXPECT_EQ(price_paid(by_tolerance, c)->error, 0.02) << "on the way";
    c.converged = true;
    c.error_limit = 0.004;
    const PricePaid p = *price_paid(by_tolerance, c);
    EXPECT_EQ(p.error, 0.004) << "what was measured, which is below what was asked for";
    EXPECT_EQ(p.threshold, 0.02) << "links are made for twice the tolerance";
    EXPECT_EQ(p.price.seconds, 2);
    EXPECT_EQ(p.price.patches, 7);
    EXPECT_EQ(p.price.bytes, 5);
    EXPECT_FALSE(price_paid(by_threshold, c, 0.005)) << "not settled";
    c.settled = true;
    EXPECT_EQ(price_paid(by_threshold, c, 0.005)->error, 0.005);
    EXPECT_FALSE(price_paid(by_threshold, c)) << "the true error is not known";
}

TEST(Price, GrowsLessWithHigherOrder) {
    for (const bool one_bounce : {false, true}) {
        Options constant, wavelet;
        constant.strategy = Strategy::discontinuity_constant;
        const PriceGrowth low = usual_growth(constant, one_bounce), high = usual_growth(wavelet, one_bounce);
        EXPECT_GT(low.seconds, high.seconds);
        EXPECT_GT(low.patches, high.patches);
    }
}

} // namespace
} // namespace penumbra
