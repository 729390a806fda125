// What an X-ray shows along its line, against closed forms and against counting rays; and that its fit is the one whose
// misfit the oracle tells.
#include "agreement/every_strategy.h"
#include "iteration/element_report.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "reference/faces.h"
#include "reference/form_factors.h"
#include "reference/rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <tuple>

namespace penumbra {
namespace {

constexpr double half = 0.6, height = 1.5; // of the lamp: half its side, and over the floor
const Rgb grey(0.5, 0.4, 0.3), shine(3, 2, 1);

reference::Face flat(double x0, double x1, double y0, double y1, double z, const Rgb &reflectance, const Rgb &exitance, bool up) {
    reference::Face f{{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}, reflectance, exitance};
    if (!up)
        std::ranges::reverse(f.corners);
    return f;
}
reference::Face floor_face() { return flat(-2, 2, -1.5, 1.5, 0, grey, Rgb::Zero(), true); }
reference::Face lamp() { return flat(-half, half, -half, half, height, Rgb::Zero(), shine, false); }
/// Black, so that light comes from the lamp alone.
reference::Face plate() { return flat(-0.2, 0.9, -0.4, 0.3, 0.7, Rgb::Zero(), Rgb::Zero(), false); }

/// Reflected light of the whole lamp.
Rgb whole(const Vec3 &x) {
    return grey * shine *
           reference::rectangle_overhead(-half - x.x(), half - x.x(), -half - x.y(), half - x.y(), height).z();
}

/// The same of what is seen of it, by rays to the middles of n x n equal parts.
Rgb seen(const Scene &scene, const Vec3 &x, int n) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec3 y(half * (2 * (i + 0.5) / n - 1), half * (2 * (j + 0.5) / n - 1), height);
            if (!reference::sees(scene, scene.own.to_solver(x), scene.own.to_solver(y)))
                continue;
            const double r2 = (y - x).squaredNorm();
            sum += height * height / (r2 * r2);
        }
    return grey * shine * sum * (4 * half * half / n / n / std::numbers::pi);
}

Vec3 place(const LinkXray &x, double at) { return x.from + at / x.length() * (x.to - x.from); }

class LinkXrays : public testing::TestWithParam<BasisAndStrategy> {
protected:
    static Options options(double threshold) {
        Options o;
        o.basis = std::get<0>(GetParam());
        o.strategy = std::get<1>(GetParam());
        o.threshold = threshold;
        o.max_depth = 3;
        return o;
    }
    static ElementReport ask(const Solver &solver, const Vec3 &point, XrayLine line) {
        return *solver.inspect(*solver.state(), {0, point, 1, line});
    }
};

TEST_P(LinkXrays, ShowWhatAnUnoccludedLampBrings) {
    Solver solver(reference::scene_of({floor_face(), lamp()}), options(0.02));
    for (int step = 0; step < 3; ++step) {
        solver.step();
        for (const XrayLine line : {XrayLine::centre, XrayLine::worst})
            for (const Vec3 &point : {Vec3(0.3, 0.2, 0), Vec3(-1.7, 1.3, 0)}) {
                const ElementReport r = ask(solver, point, line);
                ASSERT_TRUE(r.xray);
                const LinkXray &x = *r.xray;
                ASSERT_EQ(x.points.size(), static_cast<std::size_t>(n_xray_points));
                for (const XrayPoint &p : x.points)
                    EXPECT_LE((p.exact - whole(place(x, p.at))).abs().maxCoeff(), 2e-6 * whole(Vec3::Zero()).maxCoeff());
                EXPECT_LT(x.low, x.high);
                if (line == XrayLine::worst && !x.tests.empty()) {
                    const auto worst = std::ranges::find_if(x.tests, &XrayTest::worst);
                    ASSERT_NE(worst, x.tests.end());
                    EXPECT_LE(worst->off, 1e-9 * x.length());
                }
            }
    }
}

TEST_P(LinkXrays, FitIsTheOneThatTheOracleJudges) {
    // Low orders where little is asked for, all of them where much is: largest |closed form - fit| at the tests is the misfit.
    for (const double threshold : {0.3, 0.02, 0.002}) {
        Solver solver(reference::scene_of({floor_face(), lamp()}), options(threshold));
        solver.step();
        solver.step();
        const ElementReport r = ask(solver, {0.3, 0.2, 0}, XrayLine::worst);
        ASSERT_TRUE(r.xray);
        ASSERT_EQ(r.links.size(), 1U);
        ASSERT_FALSE(r.xray->tests.empty());
        double most = 0;
        for (const XrayTest &t : r.xray->tests)
            most = std::max(most, (t.point.exact - t.point.fit).abs().maxCoeff());
        const double accuracy = 0.1 * threshold; // of links
        EXPECT_NEAR(most, r.links[0].misfit, 0.02 * most + accuracy * whole(Vec3::Zero()).maxCoeff());
        EXPECT_NEAR(r.links[0].share, r.links[0].misfit / r.links[0].passes, 1e-12);
        // Of the peak: threshold / (1 + threshold) of it passes.
        EXPECT_NEAR(r.xray->passes, threshold / (1 + threshold) * r.peak, 1e-12 * r.peak);
    }
}

TEST_P(LinkXrays, ShowWhatIsLeftBehindABlocker) {
    const auto scene = reference::scene_of({floor_face(), lamp(), plate()});
    Solver solver(scene, options(0.02));
    solver.step();
    const ElementReport r = ask(solver, {0.3, 0.2, 0}, XrayLine::centre);
    ASSERT_TRUE(r.xray);
    const double peak = whole(Vec3::Zero()).maxCoeff();
    double least = peak;
    for (std::size_t k = 4; k < r.xray->points.size(); k += 12) {
        const XrayPoint &p = r.xray->points[k];
        const Rgb counted = seen(*scene, place(*r.xray, p.at), 60);
        EXPECT_LE((p.exact - counted).abs().maxCoeff(), 0.02 * peak) << k; // a column of 60 more or less
        least = std::min(least, p.exact.maxCoeff() / whole(place(*r.xray, p.at)).maxCoeff());
    }
    EXPECT_LT(least, 0.5) << "the line should cross the shadow";
}

INSTANTIATE_TEST_SUITE_P(All, LinkXrays, every_basis_and_strategy(), words_for);

} // namespace
} // namespace penumbra
