// Curves on the screen and in words, on a snapshot whose events are known.
#include "synthetic.h"

#include "render/curve_crossing.h"
#include "render/event_words.h"
#include "render/pick_curve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace penumbra {
namespace {

constexpr double aspect = 1.5, height = 600;

class Curves : public testing::Test {
protected:
    std::shared_ptr<const Snapshot> snapshot = synthetic::two_events();
    Camera camera{{-1.5, -4, 3}, {0, 0, 0.3}, {0, 0, 1}, 40};
    const SnapshotCurve &curve(std::size_t i) const { return (*snapshot->curves)[i]; }
    Vec3 middle(std::size_t i) const {
        const auto &p = curve(i).points;
        return i == 0 ? Vec3((p[0] + p[1]) / 2) : p[p.size() / 2];
    }
    /// The curve found so many pixels to the right of a point's place.
    int found(const Snapshot &s, const Vec3 &p, double pixels, const CurveFilter &filter = {}) const {
        const auto at = place_in_frame(camera, aspect, {p.x(), p.y(), p.z()});
        const auto pick =
            pick_curve(s, camera, aspect, at->x + 2 * pixels / (height * aspect), at->y, height, 6, filter);
        return pick ? pick->curve : -1;
    }
};

TEST_F(Curves, PlaceInFrameIsTheReverseOfTheViewRay) {
    const glm::dvec3 p(0.3, -0.4, 0.2);
    const auto at = place_in_frame(camera, aspect, p);
    ASSERT_TRUE(at);
    const glm::dvec3 ray = view_ray(camera, aspect, at->x, at->y);
    EXPECT_LT(glm::length(glm::cross(ray, p - camera.eye)), 1e-12);
    EXPECT_FALSE(place_in_frame(camera, aspect, camera.eye - (camera.target - camera.eye)));
}

TEST_F(Curves, TheNearestWithinReachIsPicked) {
    EXPECT_EQ(found(*snapshot, middle(0), 2), 0);
    EXPECT_EQ(found(*snapshot, middle(1), 2), 1);
    EXPECT_EQ(found(*snapshot, {-0.9, -0.9, 0}, 0), -1);
    CurveFilter filter;
    filter.kinds[0] = false;
    EXPECT_NE(found(*snapshot, middle(0), 0, filter), 0);
    filter = {};
    filter.source = 2;
    EXPECT_EQ(found(*snapshot, middle(0), 0, filter), -1);
}

TEST_F(Curves, WhatStandsBeforeACurveHidesIt) {
    Snapshot walled = *snapshot;
    SnapshotSurface wall; // upright, between eye and floor, its front towards the eye
    wall.origin = {-3, -1.5, -1};
    wall.u = {1, 0, 0};
    wall.v = {0, 0, 1};
    wall.normal = {0, -1, 0};
    wall.outline = {{0, 0}, {6, 0}, {6, 4}, {0, 4}};
    wall.reflectance = Rgb::Constant(0.5);
    wall.exitance = Rgb::Zero();
    walled.surfaces.push_back(wall);
    EXPECT_EQ(found(walled, middle(0), 0), -1);
    walled.surfaces.back().normal = {0, 1, 0}; // its back is seen through
    EXPECT_EQ(found(walled, middle(0), 0), 0);
    camera.eye.z = -3; // from below the floor
    EXPECT_EQ(found(*snapshot, middle(0), 0), -1);
}

TEST_F(Curves, AWayThatCrossesACurveIsSeenToDoSo) {
    const Vec3 across(0.05, 0, 0);
    EXPECT_THAT(crossed_curves(*snapshot, 0, middle(0) - across, middle(0) + across),
                testing::ElementsAre(testing::Field(&CurveCrossing::curve, 0)));
    EXPECT_THAT(crossed_curves(*snapshot, 0, middle(0) + across, middle(0) + 2 * across), testing::IsEmpty());
    EXPECT_THAT(crossed_curves(*snapshot, 2, middle(0) - across, middle(0) + across), testing::IsEmpty())
        << "on another surface";
    const Vec3 on = middle(1) - middle(0); // over both, in its order
    EXPECT_THAT(
        crossed_curves(*snapshot, 0, middle(0) - 0.2 * on, middle(1) + 0.2 * on),
        testing::ElementsAre(testing::Field(&CurveCrossing::curve, 0), testing::Field(&CurveCrossing::curve, 1)));
}

TEST_F(Curves, EventsAreSaidInWords) {
    const EventWords corner = event_words(*snapshot, curve(0));
    EXPECT_EQ(corner.sentence, "Crossing this line, a corner of lamp goes behind an edge of blocker.");
    EXPECT_EQ(corner.jump, "Across it the curvature of the irradiance jumps.");
    EXPECT_EQ(corner.symbol, "VE, D\u00b2");
    EXPECT_EQ(corner.way, "lamp \u2192 floor, past blocker");
    EXPECT_EQ(event_words(*snapshot, curve(1)).sentence,
              "From this line three edges, of lamp, blocker and upper, seem to meet in one point.");
    // The lower blocker lies at larger x than its edge, and so does its shadow.
    EXPECT_EQ(crossing_words(*snapshot, curve(0), middle(0) + Vec3(0.05, 0, 0)).sentence,
              "A corner of lamp went behind an edge of blocker.");
    EXPECT_EQ(crossing_words(*snapshot, curve(0), middle(0) - Vec3(0.05, 0, 0)).sentence,
              "A corner of lamp came out from behind an edge of blocker.");
}

} // namespace
} // namespace penumbra
