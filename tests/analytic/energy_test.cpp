// Energy balance: what all surfaces send out is what reflecting surfaces receive and what is lost, the lost part
// measured by rays that know nothing of the solver's visibility or links.
#include "reference/faces.h"
#include "reference/rays.h"

#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace penumbra {
namespace {

struct Balance {
    Rgb sent = Rgb::Zero(), received = Rgb::Zero(),
        lost = Rgb::Zero(); ///< fluxes [W in units of the scene's size squared]
};

/// Stratified over the patches' parameters: one ray a cell, with the power that the cell sends out. A ray is lost when
/// it leaves the scene, meets a back, or a surface that reflects nothing (what those receive the solver does not say).
Balance balance(const Scene &scene, const State &state, double rays) {
    std::mt19937 random(23);
    std::uniform_real_distribution<double> uniform;
    double whole = 0;
    for (const Surface &s : scene.surfaces)
        whole += s.area;
    Balance out;
    for (const Element &e : state.forest.elements) {
        if (!e.leaf())
            continue;
        const Surface &surface = scene.surface(e.surface);
        const Rgb rho = scene.reflectance(e.surface);
        const bool shines = scene.emits(e.surface);
        const int n = std::max(4, static_cast<int>(std::sqrt((shines ? 0.5 : 0.5 * e.basis.area() / whole) * rays)));
        const auto b = state.radiosity.middleRows(e.first, e.basis.n_functions());
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const QuadraturePoint q = e.basis.at_parameters(0, (i + uniform(random)) / n, (j + uniform(random)) / n);
                const double a = uniform(random), c = uniform(random);
                if (reference::covered(surface, q.position))
                    continue;
                const Rgb radiosity = (e.basis.evaluate(q.position).transpose() * b).transpose().array();
                const Rgb power = q.area / (n * n) * radiosity;
                out.sent += power;
                if ((rho > 0).all())
                    out.received += q.area / (n * n) * (radiosity - scene.exitance(e.surface)) / rho;
                const auto hit = reference::trace(scene, surface.frame.to_space(q.position),
                                                  reference::cosine_direction(surface.frame, a, c), 1e-9, 1e9);
                if (!hit || !hit->front || !scene.reflects(SurfaceId(hit->surface)))
                    out.lost += power;
            }
    }
    return out;
}

/// |sent - received - lost| / sent, the largest of the channels.
double imbalance(std::shared_ptr<const Scene> scene, double threshold, double rays) {
    Options options;
    options.threshold = threshold;
    Solver solver(scene, options);
    EXPECT_TRUE(solver.run());
    const Balance b = balance(*scene, *solver.state(), rays);
    EXPECT_GT(b.received.minCoeff(), 0);
    EXPECT_GT((b.lost / b.sent).minCoeff(), 0.05);
    return ((b.sent - b.received - b.lost) / b.sent).abs().maxCoeff();
}

TEST(EnergyBalance, OfTheStairs) {
    EXPECT_LT(imbalance(std::make_shared<const Scene>(open_scene("stairs")), 0.02, 4e5), 0.01);
}

TEST(EnergyBalance, OfTheCornellBox) {
    EXPECT_LT(imbalance(std::make_shared<const Scene>(open_scene("cornell-box")), 0.02, 4e5), 0.01);
}

TEST(EnergyBalance, OfTwoWalls) {
    // Nothing hidden: only the projection and the rays are in doubt.
    const auto scene =
        reference::scene_of({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, Rgb(0.8, 0.5, 0.2), Rgb(0, 1, 2)},
                             {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, Rgb(0.3, 0.6, 0.9), Rgb(1, 0, 0)}});
    EXPECT_LT(imbalance(scene, 0.005, 4e5), 0.003);
}

} // namespace
} // namespace penumbra
