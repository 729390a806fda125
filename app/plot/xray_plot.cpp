#include "plot/xray_plot.h"

#include "plot/linear_page.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

namespace penumbra {

namespace {

struct Pen {
    Canvas &canvas;
    const LinkXray &xray;
    const PlotLook &look;
    float em = look.text;

    double exact(const XrayPoint &p) const { return p.exact[xray.channel]; }
    double fit(const XrayPoint &p) const { return p.fit[xray.channel]; }
    PlotStroke solid() const { return {plot_ink(look.theme, 0.9f), 0.13f * em}; }
    PlotStroke dashed() const { return {fit_colour(), 0.13f * em, 0.45f * em}; }
    glm::vec4 fit_colour() const {
        return look.theme == Theme::dark ? glm::vec4(1, 0.66f, 0.25f, 1) : glm::vec4(0.8f, 0.38f, 0, 1);
    }
    glm::vec4 band_colour() const { return {0.35f, 0.62f, 0.9f, 0.3f}; }
    PlotText words(const glm::vec4 &colour, TextAlign align = TextAlign::left) const { return {em, colour, align, false}; }
};

/// Of all that is drawn; of a band that is wide beside it, only so much that it is seen to be.
LinearAxis value_axis(const Pen &pen) {
    std::vector<double> all;
    for (const XrayPoint &p : pen.xray.points)
        all.insert(all.end(), {pen.exact(p), pen.fit(p)});
    const auto [low, high] = std::ranges::minmax(all);
    const double reach = std::min(pen.xray.passes, std::max(1.5 * (high - low), 0.02 * high));
    for (const XrayPoint &p : pen.xray.points)
        all.insert(all.end(), {pen.exact(p) - reach, pen.exact(p) + reach});
    return linear_axis(all, 0.06);
}

void draw_band(const Pen &pen, const LinearPage &page) {
    const auto &points = pen.xray.points;
    constexpr float strip = 2; // pixels
    const double first = points.front().at, last = points.back().at;
    const float left = page.at(first, page.y.low).x, right = page.at(last, page.y.low).x;
    const int n = std::max(1, static_cast<int>((right - left) / strip));
    for (int k = 0; k < n; ++k) {
        const double part = (k + 0.5) / n * static_cast<double>(points.size() - 1);
        const auto i = static_cast<std::size_t>(part);
        const double t = part - static_cast<double>(i);
        const double middle = (1 - t) * pen.exact(points[i]) + t * pen.exact(points[std::min(i + 1, points.size() - 1)]);
        const float x = left + (right - left) * static_cast<float>(k) / static_cast<float>(n);
        const float end = left + (right - left) * static_cast<float>(k + 1) / static_cast<float>(n);
        pen.canvas.fill({{x, page.at(first, middle + pen.xray.passes).y}, {end, page.at(first, middle - pen.xray.passes).y}},
                        pen.band_colour());
    }
}

void draw_line(const Pen &pen, const LinearPage &page, const PlotStroke &stroke, auto value) {
    std::vector<glm::vec2> line;
    for (const XrayPoint &p : pen.xray.points)
        line.push_back(page.at(p.at, value(p)));
    pen.canvas.polyline(line, stroke);
}

void draw_tests(const Pen &pen, const LinearPage &page) {
    const PlotStroke outline{plot_ink(pen.look.theme), 0.09f * pen.em};
    for (const XrayTest &t : pen.xray.tests)
        if (t.near)
            pen.canvas.marker(page.at(t.point.at, pen.exact(t.point)), PlotMarker::circle, (t.worst ? 0.34f : 0.26f) * pen.em,
                              outline, t.worst ? glm::vec4(0.9f, 0.25f, 0.2f, 1) : background_colour(pen.look.theme));
}

/// Names beside strokes, in lines from the upper left; returns the height.
float draw_names(const Pen &pen, glm::vec2 corner, float width) {
    const float swatch = 1.5f * pen.em, gap = 0.35f * pen.em, line = 1.3f * pen.em;
    glm::vec2 at = corner + glm::vec2(0, 0.6f * pen.em);
    const PlotText words = pen.words(plot_ink(pen.look.theme, 0.85f));
    const auto name = [&](const std::string &text, auto draw) {
        const float all = swatch + gap + pen.canvas.text_width(text, words);
        if (at.x > corner.x && at.x + all > corner.x + width)
            at = {corner.x, at.y + line};
        draw();
        pen.canvas.text(at + glm::vec2(swatch + gap, 0), text, words);
        at.x += all + pen.em;
    };
    name("really brought", [&] { pen.canvas.line(at, at + glm::vec2(swatch, 0), pen.solid()); });
    name("the links' fit", [&] { pen.canvas.line(at, at + glm::vec2(swatch, 0), pen.dashed()); });
    name(pen.xray.mean_square ? "\u00b1 what passes in the mean" : "\u00b1 what passes", [&] {
        pen.canvas.fill({at - glm::vec2(0, 0.4f * pen.em), at + glm::vec2(swatch, 0.4f * pen.em)}, pen.band_colour());
    });
    if (std::ranges::any_of(pen.xray.tests, &XrayTest::near))
        name("tests", [&] {
            pen.canvas.marker(at + glm::vec2(swatch / 2, 0), PlotMarker::circle, 0.26f * pen.em,
                              {plot_ink(pen.look.theme), 0.09f * pen.em}, background_colour(pen.look.theme));
        });
    return at.y - corner.y + 0.7f * pen.em;
}

/// The numbers at the cursor, on a ground of their own beside the rule.
void draw_figures(const Pen &pen, const LinearPage &page, double cursor) {
    const auto &points = pen.xray.points;
    const auto after = std::ranges::lower_bound(points, cursor, {}, &XrayPoint::at);
    const XrayPoint &p = after == points.end() ? points.back() : *after;
    const std::string rows[] = {fmt::format("{:.3g} from P", p.at), fmt::format("brought {:.4g}", pen.exact(p)),
                                fmt::format("fit {:.4g} ({:+.2g})", pen.fit(p), pen.fit(p) - pen.exact(p))};
    const glm::vec4 colours[] = {plot_ink(pen.look.theme, 0.8f), plot_ink(pen.look.theme), pen.fit_colour()};
    float width = 0;
    for (const std::string &r : rows)
        width = std::max(width, pen.canvas.text_width(r, pen.words(colours[0])));
    const float x = page.at(cursor, page.y.low).x, line = 1.25f * pen.em, pad = 0.4f * pen.em;
    pen.canvas.line({x, page.box.low.y}, {x, page.box.high.y}, {plot_ink(pen.look.theme, 0.8f), 0.07f * pen.em});
    const bool on_left = x + 2 * pad + width > page.box.high.x;
    const glm::vec2 low(on_left ? x - 2 * pad - width - 0.3f * pen.em : x + 0.3f * pen.em, page.box.low.y + 0.3f * pen.em);
    glm::vec4 ground = background_colour(pen.look.theme);
    ground.a = 0.88f;
    pen.canvas.fill({low, low + glm::vec2(width + 2 * pad, 3 * line + pad)}, ground);
    for (int i = 0; i < 3; ++i)
        pen.canvas.text(low + glm::vec2(pad, pad / 2 + line * (static_cast<float>(i) + 0.5f)), rows[i], pen.words(colours[i]));
}

} // namespace

std::optional<double> XrayPlaces::place(glm::vec2 at) const {
    if (!box.contains(at))
        return std::nullopt;
    return length * static_cast<double>((at.x - box.low.x) / box.width());
}

XrayPlaces draw_xray_plot(Canvas &canvas, const PlotBox &box, const LinkXray &xray, const PlotLook &look,
                          std::optional<double> cursor) {
    const Pen pen{canvas, xray, look};
    const float em = look.text, left = box.low.x + 4.6f * em, right = box.high.x - 0.8f * em;
    const float names = draw_names(pen, {box.low.x + 0.4f * em, box.low.y + 0.2f * em}, box.width() - 0.8f * em);
    const float top = box.low.y + names + 2.1f * em, bottom = box.high.y - 3.2f * em;
    const LinearPage page{{{left, top}, {right, std::max(top + 2 * em, bottom)}}, {0, xray.length()}, value_axis(pen)};
    draw_axes(canvas, page.box, marks_of(page.x, "from P to Q across the receiver [length]", true, labels_in(right - left, 4 * em)),
              marks_of(page.y, "reflected [W/m\u00b2]", true, labels_in(page.box.height(), 2.2f * em)), look);
    canvas.clip(page.box);
    draw_band(pen, page);
    draw_line(pen, page, pen.solid(), [&](const XrayPoint &p) { return pen.exact(p); });
    draw_line(pen, page, pen.dashed(), [&](const XrayPoint &p) { return pen.fit(p); });
    draw_tests(pen, page);
    canvas.unclip();
    // Of an element above the picked one: which part is the picked one's.
    if (xray.high > xray.low && (xray.low > 0.01 * xray.length() || xray.high < 0.99 * xray.length())) {
        const float y = page.box.high.y - 0.2f * em;
        canvas.line({page.at(xray.low, 0).x, y}, {page.at(xray.high, 0).x, y}, {plot_ink(look.theme, 0.8f), 0.3f * em});
    }
    if (cursor)
        draw_figures(pen, page, *cursor);
    return {page.box, xray.length()};
}

} // namespace penumbra
