// Pictures of synthetic snapshots against baselines.
#include "baseline.h"
#include "ssim.h"
#include "synthetic.h"

#include "render/picture.h"
#include "window/offscreen.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace penumbra {
namespace {

PictureSpec picture_of(std::shared_ptr<const Snapshot> snapshot) {
    PictureSpec spec;
    spec.width = 640;
    spec.height = 480;
    spec.text = 11;
    spec.panes = {{std::move(snapshot), ""}};
    spec.camera = default_view(*spec.panes[0].snapshot, pane_aspect(spec));
    return spec;
}

void expect_golden(const std::string &name, const PictureSpec &spec) {
    const Offscreen context;
    penumbra::expect_golden(name, draw_picture(spec));
}

TEST(Golden, LampAndBlockerWithAllLayers) {
    PictureSpec spec = picture_of(synthetic::lamp_and_blocker());
    spec.look.layers.links = true;
    expect_golden("lamp-and-blocker", spec);
}

TEST(Golden, FourPanesOnPaper) {
    const auto snapshot = synthetic::lamp_and_blocker();
    PictureSpec spec = picture_of(snapshot);
    spec.panes = {{snapshot, "(a)"}, {snapshot, "(b)"}, {snapshot, "(c)"}, {snapshot, "(d)"}};
    spec.columns = 2;
    spec.look.theme = Theme::light;
    spec.camera = default_view(*snapshot, pane_aspect(spec));
    expect_golden("four-panes", spec);
}

TEST(Golden, FlatShading) {
    PictureSpec spec = picture_of(synthetic::lamp_and_blocker());
    spec.look.shading = Shading::flat;
    spec.look.layers = {false, false, false};
    expect_golden("flat", spec);
}

TEST(Golden, LinearShading) {
    PictureSpec spec = picture_of(synthetic::lamp_and_blocker());
    spec.look.shading = Shading::linear;
    spec.look.layers = {true, false, false};
    expect_golden("linear", spec);
}

TEST(Golden, ClosedRoom) { expect_golden("closed-room", picture_of(synthetic::closed_room())); }

TEST(Golden, ClosedRoomFromOutsideInFalseColour) {
    PictureSpec spec = picture_of(synthetic::closed_room());
    spec.camera = fit(orbit(spec.camera, 0.6, -0.5, spec.camera.target), *spec.panes[0].snapshot, pane_aspect(spec));
    spec.look.false_colour = true;
    expect_golden("closed-room-outside", spec);
}

TEST(Golden, PatchesOfAllShapes) { expect_golden("patch-zoo", picture_of(synthetic::patch_zoo())); }

TEST(Golden, CriticalSurfaceOfThreeEdges) {
    PictureSpec spec = picture_of(synthetic::two_events());
    spec.look.layers = {false, true, false};
    spec.look.spotlight.curve = 1;
    expect_golden("critical-surface", spec);
}

TEST(Golden, WedgeOfACornerAndAnEdgeWithTheOtherKindsHidden) {
    PictureSpec spec = picture_of(synthetic::two_events());
    spec.look.layers = {false, true, false};
    spec.look.curve_filter.kinds = {true, false, false, false, false};
    spec.look.spotlight.curve = 0;
    spec.look.theme = Theme::light;
    expect_golden("wedge", spec);
}

/// Two lamps: one half hidden, with a concave visible part, one whole.
TEST(Golden, KeyholeOfTwoLamps) {
    PictureSpec spec = picture_of(synthetic::two_events());
    auto keyhole = std::make_shared<Keyhole>();
    keyhole->surface = SurfaceId(0);
    keyhole->point = {0.3, 0.1, 0};
    const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const auto outline = [](const Polygon &p) {
        std::vector<std::pair<Vec2, Vec2>> edges;
        for (std::size_t i = 0; i < p.size(); ++i)
            edges.emplace_back(p[i], p[(i + 1) % p.size()]);
        return edges;
    };
    KeyholeEmitter half;
    half.low = {-1.4, -1.4};
    half.high = {1.4, 1.4};
    half.whole = {1, {square}, outline(square)};
    half.visible = {{{-1, -1}, {0, -1}, {0, 1}, {-1, 1}}, {{0, 0.2}, {1, 0.2}, {1, 1}, {0, 1}}};
    const Polygon blocker{{0, -2}, {2, -2}, {2, 0.2}, {0, 0.2}};
    half.blockers = {{2, {blocker}, outline(blocker)}};
    for (const Vec2 &p : {Vec2(-1, -1), Vec2(0, -1), Vec2(0, 0.2), Vec2(1, 0.2), Vec2(1, 1), Vec2(-1, 1)})
        half.corners.push_back({p, {0.5 * p.x(), 0.5 * p.y(), 2}});
    half.share = 0.7;
    half.irradiance = Rgb(3.21, 2.5, 1.75);
    KeyholeEmitter whole = half;
    whole.visible = {square};
    whole.blockers.clear();
    whole.corners.clear();
    whole.share = 1;
    whole.irradiance = Rgb::Constant(1.25);
    keyhole->emitters = {half, whole};
    spec.keyhole = keyhole;
    spec.camera = default_view(*spec.panes[0].snapshot, pane_aspect(spec));
    expect_golden("keyhole", spec);
}

// A picture that is made again takes another time, of which nothing else may move: at whatever width its line just fits.
TEST(Golden, TheTimeTakesTheSameRoomWhateverItIs) {
    const Offscreen context;
    for (int width = 300; width <= 420; width += 10) {
        const auto drawn = [&](double seconds) {
            auto snapshot = std::make_shared<Snapshot>(*synthetic::lamp_and_blocker());
            snapshot->counters.seconds = seconds;
            PictureSpec spec = picture_of(snapshot);
            spec.width = width;
            return draw_picture(spec);
        };
        const Image one = drawn(0.105), other = drawn(0.0456);
        std::size_t n = 0;
        for (std::size_t i = 0; i < one.rgb.size(); ++i)
            n += one.rgb[i] != other.rgb[i];
        EXPECT_GT(n, 0u);
        EXPECT_LT(static_cast<double>(n) / static_cast<double>(one.rgb.size()), 0.01) << width;
    }
}

// The control: what a careless change would do must not pass for the baseline.
TEST(Golden, ControlsFail) {
    const Offscreen context;
    ASSERT_TRUE(std::filesystem::exists(baseline("lamp-and-blocker")));
    const Image golden = read_png(baseline("lamp-and-blocker"));
    const auto likeness = [&](const PictureSpec &spec) { return ssim(draw_picture(spec), golden); };
    PictureSpec spec = picture_of(synthetic::lamp_and_blocker());
    spec.look.layers.links = true;

    PictureSpec changed = spec;
    changed.look.layers.curves = false;
    EXPECT_LT(likeness(changed), alike) << "curves left out";
    changed = spec;
    changed.look.shading = Shading::flat;
    EXPECT_LT(likeness(changed), alike) << "flat in place of the polynomial";
    changed = spec;
    changed.look.exposure_ev = 0.2;
    EXPECT_LT(likeness(changed), alike) << "a fifth of a stop brighter";
    changed = spec;
    changed.camera = orbit(spec.camera, 0.01, 0, spec.camera.target);
    EXPECT_LT(likeness(changed), alike) << "turned by half a degree";
    auto dimmed = std::make_shared<Snapshot>(*spec.panes[0].snapshot);
    dimmed->version += 1000000;
    for (int k = 0; k < 16; ++k) // one patch of 179
        dimmed->coefficients[static_cast<std::size_t>(k)] *= 0.8;
    changed = spec;
    changed.panes[0].snapshot = dimmed;
    EXPECT_LT(likeness(changed), alike) << "one patch a fifth darker";
}

} // namespace
} // namespace penumbra
