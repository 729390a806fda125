// SVG: what is drawn is in the file, as text that no name can break.
#include "plot/plot.h"
#include "plot/svg_canvas.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace penumbra {
namespace {

using testing::HasSubstr;

int count(const std::string &text, const std::string &part) {
    int n = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size()))
        ++n;
    return n;
}

TEST(Svg, HoldsItsPrimitives) {
    SvgCanvas svg(200, 100);
    svg.clip({{1, 2}, {11, 22}});
    svg.line({0, 0}, {10, 5}, {{1, 0, 0, 1}, 2, 4});
    svg.unclip();
    svg.marker({5, 6}, PlotMarker::circle, 3, {}, {0, 1, 0, 0.5});
    svg.marker({5, 6}, PlotMarker::cross, 3, {}, {});
    svg.text({50, 60}, "<R&D> \"x\"", {20, {}, TextAlign::right, true});
    const std::string file = svg.file();
    EXPECT_THAT(file, testing::StartsWith("<svg xmlns"));
    EXPECT_THAT(file, testing::EndsWith("</svg>\n"));
    EXPECT_THAT(file, HasSubstr("viewBox=\"0 0 200 100\""));
    EXPECT_THAT(file, HasSubstr("points=\"0.00,0.00 10.00,5.00\" fill=\"none\" stroke=\"#ff0000\" stroke-width=\"2.00\" "
                                "stroke-dasharray=\"4.00 2.80\""));
    EXPECT_THAT(file, HasSubstr("<circle cx=\"5.00\" cy=\"6.00\" r=\"3.00\" fill=\"#00ff00\" fill-opacity=\"0.5\""));
    EXPECT_EQ(count(file, "<polyline"), 3) << "a line, and a cross of two";
    EXPECT_THAT(file, HasSubstr("&lt;R&amp;D&gt; &quot;x&quot;</text>"));
    EXPECT_THAT(file, HasSubstr("text-anchor=\"end\" font-weight=\"bold\""));
    EXPECT_EQ(count(file, "<g "), count(file, "</g>"));
}

TEST(Svg, WidthsAreOfLettersNotOfBytes) {
    const SvgCanvas svg(1, 1);
    EXPECT_EQ(svg.text_width("10\u2074", {}), svg.text_width("104", {}));
}

Plot two_marks() {
    Plot plot;
    plot.x_title = "seconds";
    plot.y_title = "error";
    plot.x = {1, 100, PlotUnit::seconds};
    plot.y = {1e-4, 1, PlotUnit::share};
    PlotCurve curve;
    curve.marker = PlotMarker::square;
    curve.label = "(a)";
    curve.marks = {{1, 1, 1, 1, false, false}, {10, 1e-2, 5, 20, true, true}};
    curve.stopped = {1e-4, -1};
    plot.curves = {curve};
    return plot;
}

TEST(PlotDrawing, MarksStandWhereTheirValuesAre) {
    SvgCanvas svg(400, 300);
    const Plot plot = two_marks();
    const PlotLook look{10, Theme::light};
    const PlotBox box{{0, 0}, {400, 300}}, axes = inside_axes(box, plot, look);
    const auto placed = draw_plot(svg, box, plot, look);
    ASSERT_EQ(placed.size(), 4U);
    EXPECT_EQ(placed[0].at, glm::vec2(axes.low.x, axes.low.y)) << "the least x and the largest y";
    EXPECT_NEAR(placed[1].at.x, (axes.low.x + axes.high.x) / 2, 1e-3) << "10 is half-way from 1 to 100";
    EXPECT_NEAR(placed[1].at.y, (axes.low.y + axes.high.y) / 2, 1e-3);
    EXPECT_TRUE(placed[2].stopped);
    EXPECT_EQ(placed[2].at, axes.high) << "on the right border, at its error";
    EXPECT_EQ(placed[3].at, glm::vec2(axes.high.x, axes.low.y)) << "no error known: in the corner";
}

TEST(PlotDrawing, WhiskersCrossesAndRingsAreDrawn) {
    const auto drawn = [](const Plot &plot) {
        SvgCanvas svg(400, 300);
        draw_plot(svg, {{0, 0}, {400, 300}}, plot, {10, Theme::light});
        return svg.file();
    };
    const Plot all = two_marks();
    Plot plot = all;
    plot.curves[0].stopped.clear();
    EXPECT_EQ(count(drawn(all), "<polyline") - count(drawn(plot), "<polyline"), 2 * 2) << "two strokes a cross";
    plot = all;
    plot.curves[0].marks[1].x_low = plot.curves[0].marks[1].x_high;
    EXPECT_EQ(count(drawn(all), "<polyline") - count(drawn(plot), "<polyline"), 3) << "a whisker and its two ends";
    plot = all;
    plot.curves[0].marks[1].ringed = false;
    EXPECT_EQ(count(drawn(all), "<circle") - count(drawn(plot), "<circle"), 1);
    plot = all;
    plot.curves[0].dashed = true;
    EXPECT_THAT(drawn(plot), HasSubstr("dasharray"));
    EXPECT_THAT(drawn(all), testing::Not(HasSubstr("dasharray")));
    for (const char *words : {">seconds<", ">error<", ">(a)<", ">1 s<", ">10 s<", ">0.1 %<", ">100 %<"})
        EXPECT_THAT(drawn(all), HasSubstr(words));
}

TEST(PlotDrawing, TheMarkUnderTheMouseIsTheNearestWithinReach) {
    const std::vector<PlacedMark> marks{{0, 0, false, {10, 10}}, {1, 2, false, {14, 10}}};
    EXPECT_EQ(mark_near(marks, {13, 10}, 5)->curve, 1U);
    EXPECT_EQ(mark_near(marks, {11, 10}, 5)->curve, 0U);
    EXPECT_EQ(mark_near(marks, {30, 10}, 5), nullptr);
}

} // namespace
} // namespace penumbra
