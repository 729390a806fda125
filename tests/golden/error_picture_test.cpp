// Error pictures: what is drawn is what is wrong, and its colours are the legend's.
#include "baseline.h"
#include "ssim.h"
#include "synthetic.h"

#include "gl/framebuffer.h"
#include "iteration/error_map.h"
#include "render/error_scale.h"
#include "render/pane_renderer.h"
#include "render/pick.h"
#include "render/picture.h"
#include "window/offscreen.h"

#include <gtest/gtest.h>

#include <epoxy/gl.h>

namespace penumbra {
namespace {

constexpr int side = 192; // pixels

/// Of no patch's space.
Rgb truth_at(const Vec2 &p) { return {1 + 0.2 * std::sin(5 * p.x() + p.y()), 0.9 + 0.1 * p.x(), 1 - 0.1 * p.y()}; }

std::shared_ptr<const ErrorMap> map_of(const Snapshot &snapshot) {
    return ErrorMapper({[](int, const Vec2 &p) { return truth_at(p); }, 0}, {160, 24, 24}).map(snapshot);
}

double in_frame(int pixel) { return 2 * (pixel + 0.5) / side - 1; }

TEST(ErrorPicture, ShowsSolutionMinusTruthAtEveryPixel) {
    const Offscreen context;
    PaneRenderer renderer;
    auto snapshot = std::make_shared<Snapshot>(*synthetic::patch_zoo());
    snapshot->surfaces[0].reflectance = Rgb::Constant(0.5);
    snapshot->surfaces[0].exitance = Rgb::Zero();
    const auto map = map_of(*snapshot);
    renderer.upload(snapshot, map);
    const Camera camera{{0.5, 0.45, 2}, {0.5, 0.5, 0}, {0, 1, 0}, 32};
    for (const ErrorKind kind : {ErrorKind::signed_error, ErrorKind::relative}) {
        const gl::Framebuffer target(side, side, gl::Framebuffer::Colour::float32, 1);
        renderer.draw_error_values(camera, kind, {0, 0, side, side}, side);
        std::vector<float> rgba(4 * side * side);
        glReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, rgba.data());
        int compared = 0;
        double worst = 0, largest = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const float *shown = &rgba[4 * (static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x))];
                const auto found = pick(*snapshot, camera, 1, in_frame(x), in_frame(y));
                if (shown[3] != 1 || !found || found->patch < 0)
                    continue;
                const Vec2 p = to_plane(snapshot->surfaces[0], found->point);
                const Rgb missed = found->radiosity - truth_at(p);
                const double expected = kind == ErrorKind::signed_error
                                            ? (missed[0] + missed[1] + missed[2]) / 3
                                            : std::sqrt(missed.square().sum() / 3) / map->peak;
                ++compared;
                worst = std::max(worst, std::abs(static_cast<double>(shown[0]) - expected));
                largest = std::max(largest, std::abs(expected));
            }
        EXPECT_GT(compared, 3000);
        EXPECT_LT(worst, 0.06 * largest) << name(kind) << ": between the lattice's points it is straight";
    }
}

TEST(ErrorPicture, ColoursAreTheLegends) {
    const Offscreen context;
    PaneRenderer renderer;
    const gl::Framebuffer target(side, side, gl::Framebuffer::Colour::srgb8, 1);
    auto snapshot = std::make_shared<Snapshot>(*synthetic::patch_zoo());
    snapshot->surfaces[0].reflectance = Rgb::Constant(0.5);
    snapshot->surfaces[0].exitance = Rgb::Zero();
    const Camera camera{{0.5, 0.45, 2}, {0.5, 0.5, 0}, {0, 1, 0}, 32};
    const auto hit = pick(*snapshot, camera, 1, 1.0 / side, 1.0 / side);
    ASSERT_TRUE(hit && hit->patch >= 0);
    const auto patch = static_cast<std::size_t>(hit->patch);
    for (SnapshotPatch &p : snapshot->patches)
        p.estimate = 0.01;
    for (const ErrorKind kind : all_error_kinds)
        for (const double size : {-0.3, -0.02, 0.004, 0.05, 0.2}) {
            auto map = std::make_shared<ErrorMap>(*map_of(*snapshot));
            for (PatchError &e : map->patches)
                std::ranges::fill(e.missed, Rgb::Constant(size));
            map->peak = 1.25;
            map->patches[patch].square = size * size;
            map->reflected = 2;
            ++snapshot->version;
            map->version = snapshot->version;
            renderer.upload(snapshot, map);
            Look look;
            look.shading = Shading::error;
            look.error = kind;
            look.error_range = kind == ErrorKind::signed_error ? Range{-0.25, 0.25}
                               : kind == ErrorKind::estimate   ? Range{0.05, 20}
                                                               : Range{1e-3, 0.2};
            look.layers = {false, false, false};
            target.bind();
            renderer.draw(camera, look, {0, 0, side, side}, side);
            const Image image = read_pixels(side / 2, side / 2, 1, 1);
            const double value = kind == ErrorKind::signed_error ? size
                                 : kind == ErrorKind::relative   ? std::abs(size) / 1.25
                                 : kind == ErrorKind::patch      ? std::abs(size) / std::sqrt(2.0)
                                                                 : std::abs(size) / 0.01;
            const glm::dvec3 expected = error_colour(kind, *look.error_range, value);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(image.rgb[static_cast<std::size_t>(c)], 255 * expected[c], 1.5)
                    << name(kind) << " " << size;
        }
}

TEST(ErrorScale, IsEvenHandedAndHoldsTheValues) {
    auto snapshot = std::make_shared<Snapshot>(*synthetic::patch_zoo());
    snapshot->surfaces[0].reflectance = Rgb::Constant(0.5);
    snapshot->surfaces[0].exitance = Rgb::Zero();
    auto map = std::make_shared<ErrorMap>(*map_of(*snapshot));
    map->peak = 1;
    for (PatchError &e : map->patches)
        std::ranges::fill(e.missed, Rgb::Constant(-0.013));
    const Judged judged{snapshot.get(), map.get()};
    EXPECT_EQ(error_range(ErrorKind::signed_error, {&judged, 1}), (Range{-0.02, 0.02}));
    const Range relative = error_range(ErrorKind::relative, {&judged, 1});
    EXPECT_NEAR(relative.high, 0.1, 1e-12);
    EXPECT_NEAR(relative.low, 0.01, 1e-12);
    const Range estimate = error_range(ErrorKind::estimate, {&judged, 1});
    EXPECT_NEAR(estimate.low * estimate.high, 1, 1e-12);
    EXPECT_EQ(place(ErrorKind::signed_error, {-2, 2}, 0), 0.5);
    EXPECT_NEAR(place(ErrorKind::estimate, {0.01, 100}, 1), 0.5, 1e-12);
    EXPECT_NEAR(place(ErrorKind::patch, {1e-4, 1}, 1e-3), 0.25, 1e-12);
}

PictureSpec picture(ErrorKind kind, Theme theme) {
    auto snapshot = std::make_shared<Snapshot>(*synthetic::lamp_and_blocker());
    for (std::size_t i = 0; i < snapshot->patches.size(); ++i)
        snapshot->patches[i].estimate = 0.02 * std::pow(10.0, std::sin(static_cast<double>(i)));
    PictureSpec spec;
    spec.width = 640;
    spec.height = 480;
    spec.text = 11;
    spec.panes = {{snapshot, "", map_of(*snapshot)}};
    spec.look.shading = Shading::error;
    spec.look.error = kind;
    spec.look.theme = theme;
    spec.look.layers = {true, false, false};
    spec.camera = default_view(*snapshot, pane_aspect(spec));
    return spec;
}

TEST(GoldenError, Signed) {
    const Offscreen context;
    expect_golden("error-signed", draw_picture(picture(ErrorKind::signed_error, Theme::dark)));
}

TEST(GoldenError, AgainstTheEstimateOnPaper) {
    const Offscreen context;
    expect_golden("error-estimate", draw_picture(picture(ErrorKind::estimate, Theme::light)));
}

TEST(GoldenError, ControlsFail) {
    const Offscreen context;
    ASSERT_TRUE(std::filesystem::exists(baseline("error-signed")));
    const Image golden = read_png(baseline("error-signed"));
    PictureSpec spec = picture(ErrorKind::signed_error, Theme::dark);
    spec.panes[0].errors.reset();
    EXPECT_LT(ssim(draw_picture(spec), golden), alike) << "the light in place of the error";
    spec = picture(ErrorKind::relative, Theme::dark);
    EXPECT_LT(ssim(draw_picture(spec), golden), alike) << "another kind";
    spec = picture(ErrorKind::signed_error, Theme::dark);
    auto map = std::make_shared<ErrorMap>(*spec.panes[0].errors);
    spec.look.error_range = error_range(ErrorKind::signed_error, judged(spec));
    for (PatchError &e : map->patches)
        for (Rgb &m : e.missed)
            m *= 0.8;
    spec.panes[0].errors = map;
    EXPECT_LT(ssim(draw_picture(spec), golden), alike) << "a fifth less wrong";
}

} // namespace
} // namespace penumbra
