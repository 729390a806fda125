// The sheet of costs against baselines, and what must not pass for it.
#include "baseline.h"
#include "ssim.h"

#include "plot/cost_sheet.h"
#include "plot/made_up_study.h"
#include "plot/plot_picture.h"
#include "window/offscreen.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

constexpr int width = 1200, height = 520;
constexpr float text = 12;

Image sheet(const CostStudy &study, Theme theme) {
    const Offscreen context;
    return draw_plot_picture(width, height, text, theme, [&](Canvas &canvas) {
        draw_cost_sheet(canvas, {width, height}, study, {text, theme});
    });
}

TEST(GoldenPlot, CostOnPaper) { expect_golden("cost", sheet(made_up_study(), Theme::light)); }
TEST(GoldenPlot, CostInTheDark) { expect_golden("cost-dark", sheet(made_up_study(), Theme::dark)); }

TEST(GoldenPlot, ControlsFail) {
    ASSERT_TRUE(std::filesystem::exists(baseline("cost")));
    const Image golden = read_png(baseline("cost"));
    const auto likeness = [&](const CostStudy &study) { return ssim(sheet(study, Theme::light), golden); };
    CostStudy changed = made_up_study();
    for (CostPoint &p : changed.points)
        if (p.options.strategy == Strategy::uniform_constant && !p.done())
            p.end = RunEnd::interrupted;
    EXPECT_LT(likeness(changed), alike) << "crosses left out";
    changed = made_up_study();
    for (CostPoint &p : changed.points)
        p.seconds.resize(std::min<std::size_t>(p.seconds.size(), 1));
    EXPECT_LT(likeness(changed), alike) << "whiskers left out";
    changed = made_up_study();
    changed.points[12].error *= 0.8;
    EXPECT_LT(likeness(changed), alike) << "one error a fifth smaller";
    changed = made_up_study();
    for (CostPoint &p : changed.points)
        if (p.options.basis == BasisFamily::planar)
            p.options.strategy = Strategy::uniform_constant;
    EXPECT_LT(likeness(changed), alike) << "colours and markers wrong";
}

} // namespace
} // namespace penumbra
