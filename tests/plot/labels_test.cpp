// Labels stand beside their curves, inside the plot and apart; and dashes are as long as asked.
#include "plot/dashes.h"
#include "plot/label_places.h"

#include <gmock/gmock.h>

namespace penumbra {
namespace {

const PlotBox page{{0, 0}, {400, 300}};

bool apart(const PlotBox &a, const PlotBox &b) {
    return a.high.x <= b.low.x || b.high.x <= a.low.x || a.high.y <= b.low.y || b.high.y <= a.low.y;
}

TEST(Labels, StandBesideTheLastAnchorWhereThatIsFree) {
    const auto boxes = place_labels(page, {{{{50, 50}, {200, 150}}, 60}}, {}, 20);
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_FLOAT_EQ(boxes[0].low.x, 200 + 15) << "three quarters of its height away from the mark";
    EXPECT_FLOAT_EQ(boxes[0].width(), 60);
    EXPECT_FLOAT_EQ((boxes[0].low.y + boxes[0].high.y) / 2, 150);
}

TEST(Labels, StayInsideAtEveryCornerOfThePlot) {
    for (const glm::vec2 corner : {glm::vec2(2, 2), glm::vec2(398, 2), glm::vec2(2, 298), glm::vec2(398, 298)}) {
        const PlotBox b = place_labels(page, {{{corner}, 80}}, {}, 20)[0];
        // In a corner a label whose middle stands at the mark's height sticks out by at most half its height.
        EXPECT_TRUE(page.contains({b.low.x, (b.low.y + b.high.y) / 2})) << corner.x << ' ' << corner.y;
        EXPECT_TRUE(page.contains({b.high.x, (b.low.y + b.high.y) / 2})) << corner.x << ' ' << corner.y;
    }
}

TEST(Labels, OfCurvesThatEndInOnePlaceAreApart) {
    const LabelWish wish{{{100, 60}, {200, 150}}, 70};
    const auto boxes = place_labels(page, {wish, wish, wish, wish}, {}, 20);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_TRUE(apart(boxes[i], boxes[j])) << i << " and " << j;
}

TEST(Labels, LeaveMarksFree) {
    const std::vector<glm::vec2> taken{{230, 150}, {250, 150}}; // where the label would stand
    const PlotBox b = place_labels(page, {{{{200, 150}}, 60}}, taken, 20)[0];
    for (const glm::vec2 &p : taken)
        EXPECT_FALSE(b.contains(p));
}

TEST(Labels, ThereIsNoneWhereNoneIsWished) { EXPECT_EQ(place_labels(page, {{{{9, 9}}, 0}}, {}, 20)[0].width(), 0); }

float length(const std::vector<glm::vec2> &line) {
    float sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        sum += glm::distance(line[i], line[i + 1]);
    return sum;
}

TEST(Dashes, AreAsLongAsAskedAndGoAroundCorners) {
    const glm::vec2 line[] = {{0, 0}, {10, 0}, {10, 10}};
    const auto all = dashes(line, 4, 3); // 0-4, 7-11 around the corner, 14-18
    ASSERT_EQ(all.size(), 3U);
    for (const auto &dash : all)
        EXPECT_NEAR(length(dash), 4, 1e-5);
    EXPECT_THAT(all[1], testing::SizeIs(3)) << "with the corner";
    EXPECT_NEAR(all[1].back().y, 1, 1e-5);
    EXPECT_NEAR(all[2].front().y, 4, 1e-5);
}

TEST(Dashes, TheirShareOfALongLineIsRight) {
    const glm::vec2 line[] = {{3, 1}, {1003, 1}};
    float drawn = 0;
    for (const auto &dash : dashes(line, 0.9f, 0.6f))
        drawn += length(dash);
    EXPECT_NEAR(drawn / 1000, 0.6, 0.002); // lengths that no float holds exactly must not stop it
}

} // namespace
} // namespace penumbra
