// In a closed box of uniform walls B = E / (1 - rho), whatever stands in it.
#include "reference/faces.h"
#include "reference/rays.h"

#include "iteration/solver.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace penumbra {
namespace {

const Rgb rho(0.5, 0.6, 0.3), glow = 2 * (1 - rho);

struct Deviation {
    // Of |B (1 - rho) / E - 1|, largest channel: over all points, root mean square over the area, and the share of the
    // area where it is above 2 %.
    double largest = 0, mean = 0, share_beyond = 0;
};

Deviation deviation(std::shared_ptr<const Scene> scene, const Options &options) {
    Solver solver(scene, options);
    EXPECT_TRUE(solver.run());
    const auto snapshot = solver.snapshot();
    EXPECT_GE(snapshot->patches.size(), 6U);
    constexpr int n = 9; // points a parameter of every patch
    Deviation out;
    double squares = 0, area = 0, beyond = 0;
    for (const SnapshotPatch &patch : snapshot->patches) {
        const SnapshotSurface &plane = snapshot->surfaces[static_cast<std::size_t>(patch.surface)];
        const Surface &surface = scene->surface(SurfaceId(patch.surface));
        const Material &material = scene->material(SurfaceId(patch.surface));
        const Rgb expected = material.exitance / (1 - material.reflectance);
        const std::array<Vec2, 4> &c = patch.quad;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double u = (i + 0.5) / n, v = (j + 0.5) / n;
                const Vec2 p = (1 - v) * ((1 - u) * c[0] + u * c[1]) + v * ((1 - u) * c[3] + u * c[2]);
                const Vec2 own =
                    surface.frame.to_plane(scene->own.to_solver(plane.origin + p.x() * plane.u + p.y() * plane.v));
                if (reference::covered(surface, own))
                    continue;
                const double error = (radiosity(*snapshot, patch, p) / expected - 1).abs().maxCoeff();
                const Vec2 du = (1 - v) * (c[1] - c[0]) + v * (c[2] - c[3]),
                           dv = (1 - u) * (c[3] - c[0]) + u * (c[2] - c[1]);
                const double weight = std::abs(cross(du, dv));
                out.largest = std::max(out.largest, error);
                squares += weight * error * error;
                beyond += error > 0.02 ? weight : 0;
                area += weight;
            }
    }
    out.mean = std::sqrt(squares / area);
    out.share_beyond = beyond / area;
    return out;
}

Options options_of(Strategy strategy, double threshold) {
    Options options;
    options.strategy = strategy;
    options.threshold = threshold;
    return options;
}

std::vector<reference::Face> walls() {
    return reference::turned_over(reference::box({0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}, {0, 0, 0.8}, rho, glow));
}

constexpr double allowed = 0.005;

TEST(Furnace, Bundled) {
    const auto scene = std::make_shared<const Scene>(open_scene("furnace"));
    EXPECT_LT(deviation(scene, options_of(Strategy::discontinuity_wavelet, 0.01)).largest, allowed);
}

TEST(Furnace, EmptyBoxOfUnequalSides) {
    EXPECT_LT(deviation(reference::scene_of(walls()), options_of(Strategy::uniform_wavelet, 0.01)).largest, allowed);
}

/// A box that is turned by half a radian.
std::vector<reference::Face> walls_and_box(double height_above_floor) {
    auto faces = walls();
    const double c = std::cos(0.5), s = std::sin(0.5);
    for (const auto &face : reference::box({0.35, 0.4, height_above_floor}, 0.3 * Vec3(c, s, 0), 0.5 * Vec3(-s, c, 0),
                                           {0, 0, 0.25}, rho, glow))
        faces.push_back(face);
    return faces;
}

// With hidden parts the promise is one of means: where three surfaces meet, what each brings is a function of direction
// alone, and its largest misfit falls on no level (DESIGN section 3), though the area it holds does.

TEST(Furnace, WithAClosedBoxInside) {
    const auto d =
        deviation(reference::scene_of(walls_and_box(0.2)), options_of(Strategy::discontinuity_wavelet, 0.01));
    EXPECT_LT(d.mean, allowed);
    EXPECT_LT(d.share_beyond, 0.005);
}

TEST(Furnace, WithABoxOnItsFloor) {
    const auto d = deviation(reference::scene_of(walls_and_box(0)), options_of(Strategy::discontinuity_wavelet, 0.01));
    EXPECT_LT(d.mean, allowed);
    EXPECT_LT(d.share_beyond, 0.005);
}

} // namespace
} // namespace penumbra
