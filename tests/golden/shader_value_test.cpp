// What the shaders compute is what the solver says: radiosity read back from a target of floats, and tones.
#include "synthetic.h"

#include "capture.h"
#include "gl/framebuffer.h"
#include "render/pane_renderer.h"
#include "render/pick.h"
#include "render/surface_role.h"
#include "render/tone.h"
#include "window/offscreen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <epoxy/gl.h>

namespace penumbra {
namespace {

constexpr int side = 192; // pixels

struct Values {
    std::vector<float> rgba;
    const float *at(int x, int y) const { return &rgba[4 * (static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x))]; }
};

/// Radiosities as the shader sees them; rows from the bottom.
Values draw_values(PaneRenderer &renderer, const Camera &camera, Shading shading) {
    const gl::Framebuffer target(side, side, gl::Framebuffer::Colour::float32, 1);
    renderer.draw_values(camera, shading, {0, 0, side, side}, side);
    Values values{std::vector<float>(4 * side * side)};
    glReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, values.rgba.data());
    return values;
}

double in_frame(int pixel) { return 2 * (pixel + 0.5) / side - 1; }

/// From above, filled by the patch; slanted a little, so that perspective has a say. Of a long patch a part is shown.
Camera over(const Snapshot &snapshot, const SnapshotPatch &patch) {
    const SnapshotSurface &s = snapshot.surfaces[static_cast<std::size_t>(patch.surface)];
    Vec2 middle = Vec2::Zero();
    double twice_area = 0, longest = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        middle += patch.quad[k] / 4;
        twice_area += cross(patch.quad[k], patch.quad[(k + 1) % 4]);
        longest = std::max(longest, (patch.quad[(k + 1) % 4] - patch.quad[k]).norm());
    }
    const double breadth = std::min(longest, 4 * twice_area / longest);
    const Vec3 target = to_space(s, middle), eye = target + 2 * breadth * (s.normal + 0.2 * s.u + 0.1 * s.v);
    return {{eye.x(), eye.y(), eye.z()}, {target.x(), target.y(), target.z()}, {0, 1, 0}, 32};
}

/// How much the radiosity changes when its place moves by what single precision and the rasteriser's grid cannot tell
/// apart: next to nothing, but at the apex of a triangle, where all values of a side meet.
double blur(const Snapshot &snapshot, const Pick &at) {
    const SnapshotSurface &s = snapshot.surfaces[static_cast<std::size_t>(at.surface)];
    const SnapshotPatch &patch = snapshot.patches[static_cast<std::size_t>(at.patch)];
    const Vec2 p((at.point - s.origin).dot(s.u), (at.point - s.origin).dot(s.v));
    constexpr double ulp = 5e-7; // of coordinates around 1
    double most = 0;
    for (const Vec2 &step : {Vec2(ulp, 0), Vec2(-ulp, 0), Vec2(0, ulp), Vec2(0, -ulp)})
        most = std::max(most, (radiosity(snapshot, patch, p + step) - at.radiosity).abs().maxCoeff());
    return most;
}

TEST(ShaderValue, EqualsTheSolversOnPatchesOfAllShapes) {
    const Offscreen context;
    PaneRenderer renderer;
    const auto snapshot = synthetic::patch_zoo();
    renderer.upload(snapshot);
    for (std::size_t i = 0; i < snapshot->patches.size(); ++i) {
        const Camera camera = over(*snapshot, snapshot->patches[i]);
        const Values values = draw_values(renderer, camera, Shading::polynomial);
        int compared = 0, blurred = 0;
        double worst = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto expected = pick(*snapshot, camera, 1, in_frame(x), in_frame(y));
                if (values.at(x, y)[3] != 1 || !expected || expected->patch != static_cast<int>(i))
                    continue;
                const double slack = blur(*snapshot, *expected);
                if (slack > 1e-5) {
                    ++blurred;
                    continue;
                }
                ++compared;
                for (int c = 0; c < 3; ++c)
                    worst = std::max(worst, std::abs(values.at(x, y)[c] - expected->radiosity[c]) - slack);
            }
        EXPECT_GT(compared, 1000) << "patch " << i;
        EXPECT_LT(blurred, compared / 20) << "patch " << i;
        EXPECT_LT(worst, 1e-5) << "patch " << i << ", values around 1";
    }
}

TEST(ShaderValue, FlatIsTheMeanOverTheArea) {
    const Offscreen context;
    PaneRenderer renderer;
    const auto snapshot = synthetic::patch_zoo();
    renderer.upload(snapshot);
    for (const SnapshotPatch &patch : snapshot->patches) {
        // Midpoints of a fine grid of parameters, weighted by the Jacobian: by another way than the renderer's.
        constexpr int n = 100;
        const auto &c = patch.quad;
        Rgb sum = Rgb::Zero();
        double area = 0;
        for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b) {
                const double u = (a + 0.5) / n, v = (b + 0.5) / n;
                const double weight = cross((1 - v) * (c[1] - c[0]) + v * (c[2] - c[3]), (1 - u) * (c[3] - c[0]) + u * (c[2] - c[1]));
                sum += weight * radiosity_at(*snapshot, patch, u, v);
                area += weight;
            }
        const Values values = draw_values(renderer, over(*snapshot, patch), Shading::flat);
        const float *middle = values.at(side / 2, side / 2);
        ASSERT_EQ(middle[3], 1);
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(middle[k], sum[k] / area, 1e-4);
    }
}

TEST(ShaderValue, ToneIsTheLegends) {
    const Offscreen context;
    PaneRenderer renderer;
    auto snapshot = std::make_shared<Snapshot>(*synthetic::patch_zoo());
    const Camera camera = over(*snapshot, snapshot->patches[0]);
    const gl::Framebuffer target(side, side, gl::Framebuffer::Colour::srgb8, 1);
    for (const bool false_colour : {false, true})
        for (const double value : {0.0, 0.01, 0.3, 0.8, 1.0, 1.7, 5.0}) {
            Look look;
            look.false_colour = false_colour;
            look.exposure_ev = 0.5;
            look.range = Range{0.1, 1.9};
            look.layers = {false, false, false};
            for (Rgb &c : snapshot->coefficients)
                c = Rgb::Zero();
            snapshot->coefficients[static_cast<std::size_t>(snapshot->patches[0].first)] = Rgb::Constant(value);
            ++snapshot->version;
            renderer.upload(snapshot);
            target.bind();
            renderer.draw(camera, look, {0, 0, side, side}, side);
            const Image image = read_pixels(side / 2, side / 2, 1, 1);
            const glm::dvec3 expected = shown(look, *look.range, value);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(image.rgb[static_cast<std::size_t>(c)], 255 * expected[c], 1) << value;
        }
}

TEST(ShaderValue, LampInTheCeilingsPlaneIsOnTop) {
    const Offscreen context;
    PaneRenderer renderer;
    const auto snapshot = synthetic::closed_room();
    renderer.upload(snapshot);
    Camera camera;
    camera.eye = {0.5, 0.45, 0.1};
    camera.target = {0.5, 0.5, 1};
    camera.up = {0, 1, 0};
    const Values values = draw_values(renderer, camera, Shading::polynomial);
    EXPECT_EQ(values.at(side / 2, side / 2)[0], 60) << "the lamp's, not the ceiling's";
    const auto found = pick(*snapshot, camera, 1, 0, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(snapshot->surfaces[static_cast<std::size_t>(found->surface)].name, "lamp");
}

TEST(ShaderValue, WallsAreSeenThroughFromBehind) {
    const Offscreen context;
    PaneRenderer renderer;
    const auto snapshot = synthetic::closed_room();
    renderer.upload(snapshot);
    const Camera camera{{0.5, -3, 0.8}, {0.5, 1, 0.8}, {0, 0, 1}, 20}; // before the front wall
    const Values values = draw_values(renderer, camera, Shading::polynomial);
    const auto found = pick(*snapshot, camera, 1, 0, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(snapshot->surfaces[static_cast<std::size_t>(found->surface)].name, "back");
    EXPECT_NEAR(values.at(side / 2, side / 2)[0], pick(*snapshot, camera, 1, 1.0 / side, 1.0 / side)->radiosity[0], 1e-5);
}

} // namespace
} // namespace penumbra
