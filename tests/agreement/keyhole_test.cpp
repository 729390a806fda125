// What the keyhole says of a point, against rays, against the direct solution, against shapes read off shadows, and the
// picture against itself: bright is what lies in the emitter and in no blocker.
#include "discontinuity/visible_shape.h"
#include "reference/rays.h"

#include "measure/direct.h"
#include "measure/keyhole.h"
#include "measure/visible_corners.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace penumbra {
namespace {

constexpr double slack = 1e-9;

bool in_any(const std::vector<Polygon> &polygons, const Vec2 &p, double by) {
    return std::ranges::any_of(polygons, [&](const Polygon &polygon) { return contains(polygon, p, by); });
}

/// Random points of the reflecting surfaces, away from their borders.
struct Place {
    SurfaceId surface;
    Vec2 at;
};
std::vector<Place> places(const Scene &scene, int n) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform;
    std::vector<Place> result;
    for (int s = 0; s < scene.n_surfaces(); ++s) {
        if (!scene.reflects(SurfaceId(s)))
            continue;
        Vec2 low = Vec2::Constant(1e300), high = -low;
        for (const Vec2 &p : scene.surface(SurfaceId(s)).outline) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        for (int i = 0; i < n; ++i) {
            const Vec2 p = low + (high - low).cwiseProduct(Vec2(uniform(random), uniform(random)));
            if (reference::inside(scene.surface(SurfaceId(s)).outline, p))
                result.push_back({SurfaceId(s), p});
        }
    }
    return result;
}

class KeyholeOf : public testing::TestWithParam<const char *> {
protected:
    std::shared_ptr<const Scene> scene = std::make_shared<const Scene>(open_scene(GetParam()));
    KeyholeEye eye{scene};
    Keyhole look(const Place &place) const {
        return eye.look(place.surface, scene->own.to_own(scene->surface(place.surface).frame.to_space(place.at)));
    }
};

TEST_P(KeyholeOf, SharesAgreeWithRays) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform;
    for (const Place &place : places(*scene, 6)) {
        const Keyhole keyhole = look(place);
        for (const KeyholeEmitter &emitter : keyhole.emitters) {
            const Surface &source = scene->surface(SurfaceId(emitter.whole.surface));
            const Surface &receiver = scene->surface(place.surface);
            const Vec3 x = receiver.frame.to_space(place.at);
            Vec2 low = Vec2::Constant(1e300), high = -low;
            for (const Vec2 &p : source.outline) {
                low = low.cwiseMin(p);
                high = high.cwiseMax(p);
            }
            constexpr int n = 60;
            double seen = 0, all = 0;
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const Vec2 p =
                        low + (high - low).cwiseProduct(Vec2((i + uniform(random)) / n, (j + uniform(random)) / n));
                    if (!reference::inside(source.outline, p) || reference::covered(source, p))
                        continue;
                    ++all;
                    const Vec3 y = source.frame.to_space(p);
                    seen += receiver.frame.height(y) > 0 && reference::sees(*scene, x, y) ? 1 : 0;
                }
            EXPECT_NEAR(emitter.share, seen / all, 0.01)
                << "surface " << place.surface.index << " at " << x.transpose();
        }
    }
}

TEST_P(KeyholeOf, IrradiancesSumUpToTheDirectSolution) {
    const Blockers blockers(*scene);
    for (const Place &place : places(*scene, 20)) {
        Rgb sum = Rgb::Zero();
        for (const KeyholeEmitter &emitter : look(place).emitters)
            sum += emitter.irradiance;
        const Rgb direct = direct_radiosity(*scene, blockers, place.surface, place.at);
        const Rgb ours = scene->exitance(place.surface) + scene->reflectance(place.surface) * sum;
        EXPECT_LT((direct - ours).abs().maxCoeff(), 1e-12 * (1 + direct.maxCoeff()));
    }
}

TEST_P(KeyholeOf, CornersAreThoseThatShadowsTell) {
    int n_corners = 0, n_wrong = 0, n = 0;
    for (const Place &place : places(*scene, 60))
        for (const KeyholeEmitter &emitter : look(place).emitters) {
            const ShapeReader reader(*scene, SurfaceId(emitter.whole.surface), place.surface);
            const auto shape = reader.at(place.at);
            n_corners += static_cast<int>(emitter.corners.size());
            n_wrong += shape.size() != emitter.corners.size();
            ++n;
        }
    EXPECT_GT(n_corners, 60);
    EXPECT_LE(n_wrong, n / 100) << "of " << n; // a random point may lie within rounding of a curve
}

TEST_P(KeyholeOf, WhatIsBrightLiesInTheEmitterAndInNoBlocker) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform;
    int n_bright = 0, n_dark = 0;
    for (const Place &place : places(*scene, 20))
        for (const KeyholeEmitter &e : look(place).emitters)
            for (int i = 0; i < 200; ++i) {
                const Vec2 p = e.low + (e.high - e.low).cwiseProduct(Vec2(uniform(random), uniform(random)));
                const auto free_of_blockers = [&](double by) {
                    return std::ranges::none_of(e.blockers, [&](const auto &b) { return in_any(b.parts, p, by); });
                };
                if (in_any(e.visible, p, -slack)) {
                    EXPECT_TRUE(in_any(e.whole.parts, p, slack) && free_of_blockers(-slack)) << p.transpose();
                    ++n_bright;
                } else if (!in_any(e.visible, p, slack)) {
                    EXPECT_FALSE(in_any(e.whole.parts, p, -slack) && free_of_blockers(slack)) << p.transpose();
                    ++n_dark;
                }
            }
    EXPECT_GT(n_bright, 300);
    EXPECT_GT(n_dark, 300);
}

INSTANTIATE_TEST_SUITE_P(Bundled, KeyholeOf, testing::Values("skew-blockers", "slanted-edge", "box-on-floor", "stairs"),
                         [](const auto &test) {
                             std::string name = test.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST(CornersOfUnion, WherePiecesMeetThereIsNone) {
    ConvexPieces l_shape; // three squares, the joins cut at different heights
    l_shape.add(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    l_shape.add(std::vector<Vec2>{{1, 0}, {2, 0}, {2, 1}, {1, 1}});
    l_shape.add(std::vector<Vec2>{{0, 1}, {0.5, 1}, {0.5, 2}, {0, 2}});
    l_shape.add(std::vector<Vec2>{{0.5, 1}, {1, 1}, {1, 2}, {0.5, 2}});
    EXPECT_EQ(corners_of_union(l_shape, 1e-10).size(), 6u);
    ConvexPieces touching; // in one point, which is one corner
    touching.add(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    touching.add(std::vector<Vec2>{{1, 1}, {2, 1}, {2, 2}, {1, 2}});
    EXPECT_EQ(corners_of_union(touching, 1e-10).size(), 7u);
}

TEST(Keyhole, SurfaceAtFindsTheNearestReflector) {
    const auto scene = std::make_shared<const Scene>(open_scene("box-on-floor"));
    const KeyholeEye eye(scene);
    EXPECT_EQ(eye.surface_at({1, 1, 1e-4}, 1e-3).index, 0);
    EXPECT_FALSE(eye.surface_at({1, 1, 0.5}, 1e-3).valid());
    EXPECT_TRUE(eye.look(SurfaceId(0), {0, 0, 0}).emitters.empty()) << "under the box";
}

} // namespace
} // namespace penumbra
