#include "plot/profile_sheet.h"

#include "plot/linear_page.h"
#include "plot/strategy_style.h"
#include "render/curve_pass.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace penumbra {

namespace {

struct Pen {
    Canvas &canvas;
    const ProfileData &data;
    const PlotLook &look;
    float em = look.text;

    glm::vec4 ink(float opacity = 1) const { return plot_ink(look.theme, opacity); }
    PlotText words(const glm::vec4 &colour, TextAlign align = TextAlign::left, bool bold = false) const {
        return {em, colour, align, bold};
    }
    PlotStroke truth() const { return {ink(0.3f), 0.34f * em}; }
    PlotStroke stroke(const ProfileCurve &c) const {
        return {strategy_colour(c.strategy, look.theme), 0.11f * em, c.reconstructed ? 0.5f * em : 0};
    }
};

std::string long_name(const ProfileCurve &c) {
    return strategy_label(c.strategy, c.order) + (c.reconstructed ? " as quadratics" : "");
}

/// "(b)", or "(bq)" as the command line has it.
std::string short_name(const ProfileCurve &c) {
    return strategy_label(c.strategy, c.order).substr(0, 2) + (c.reconstructed ? "q)" : ")");
}

enum class Shown { value, slope };
double number(const ProfilePoint &p, Shown what) { return channel_mean(what == Shown::value ? p.radiosity : p.slope); }

/// The line through the points, which lie left to right.
void draw_line(const Pen &pen, const LinearPage &page, const std::vector<ProfilePoint> &points, Shown what,
               const PlotStroke &stroke) {
    std::vector<glm::vec2> line;
    for (const ProfilePoint &p : points)
        if (const glm::vec2 at = page.at(p.at, number(p, what)); line.empty() || glm::distance(line.back(), at) > 0.05f)
            line.push_back(at);
    if (line.size() > 1)
        pen.canvas.polyline(line, stroke);
}

/// A piece each, and over a border the jump from one to the next, fainter.
void draw_solution(const Pen &pen, const LinearPage &page, const ProfileCurve &curve, Shown what) {
    const PlotStroke stroke = pen.stroke(curve);
    for (std::size_t i = 0; i < curve.pieces.size(); ++i) {
        draw_line(pen, page, curve.pieces[i].points, what, stroke);
        if (i == 0 || what == Shown::slope)
            continue;
        PlotStroke jump = stroke;
        jump.colour.a = 0.45f;
        const ProfilePoint &before = curve.pieces[i - 1].points.back(), &after = curve.pieces[i].points.front();
        const glm::vec2 a = page.at(before.at, number(before, what)), b = page.at(after.at, number(after, what));
        if (glm::distance(a, b) > 0.05f)
            pen.canvas.line(a, b, jump);
    }
}

void draw_crossings(const Pen &pen, const LinearPage &page, const glm::vec2 &reach) {
    for (const ProfileCrossing &c : pen.data.crossings) {
        const float x = page.at(c.at, page.y.low).x;
        glm::vec4 colour = curve_rgba(c.kind);
        colour.a = 0.8f;
        pen.canvas.line({x, reach.x}, {x, reach.y}, {colour, 0.08f * pen.em, c.order == 2 ? 0.3f * pen.em : 0});
    }
}

LinearAxis value_axis(const ProfileData &data) {
    std::vector<double> all;
    for (const ProfilePoint &p : data.exact)
        all.push_back(number(p, Shown::value));
    for (const ProfileCurve &c : data.curves)
        for (const ProfilePiece &piece : c.pieces)
            for (const ProfilePoint &p : piece.points)
                all.push_back(number(p, Shown::value));
    return linear_axis(all, 0.06);
}

/// Of nine tenths and more of the slopes: at a jump of the light itself they are as large as one likes.
LinearAxis slope_axis(const ProfileData &data) {
    std::vector<double> all;
    for (const ProfilePoint &p : data.exact)
        all.push_back(number(p, Shown::slope));
    if (all.empty())
        for (const ProfileCurve &c : data.curves)
            for (const ProfilePiece &piece : c.pieces)
                for (const ProfilePoint &p : piece.points)
                    all.push_back(number(p, Shown::slope));
    std::ranges::sort(all);
    if (const std::size_t cut = all.size() / 50; cut > 0)
        all = {all.begin() + static_cast<std::ptrdiff_t>(cut), all.end() - static_cast<std::ptrdiff_t>(cut)};
    all.push_back(0);
    return linear_axis(all, 0.2);
}

/// A row of ticks for each solution where its elements end, in its colour.
void draw_borders(const Pen &pen, const LinearPage &page, float top, float row) {
    for (std::size_t i = 0; i < pen.data.curves.size(); ++i) {
        const ProfileCurve &curve = pen.data.curves[i];
        PlotStroke stroke = pen.stroke(curve);
        stroke.dash = 0;
        const float y = top + static_cast<float>(i) * row;
        pen.canvas.line({page.box.low.x, y + row / 2}, {page.box.high.x, y + row / 2},
                        {pen.ink(0.12f), 0.05f * pen.em});
        for (const ProfilePiece &piece : curve.pieces) {
            const auto tick = [&](double at) {
                const float x = page.at(at, page.y.low).x;
                pen.canvas.line({x, y + 0.12f * row}, {x, y + 0.88f * row}, stroke);
            };
            tick(piece.low);
            tick(piece.high);
        }
        const std::string letter = short_name(curve);
        PlotText words = pen.words(stroke.colour, TextAlign::right, true);
        words.size = std::min(pen.em, 1.1f * row);
        pen.canvas.text({page.box.low.x - 0.5f * pen.em, y + row / 2}, letter, words);
    }
}

std::string truth_name(const ProfileData &data) {
    return data.truth_error > 0 ? fmt::format("reference (good to {:.2g} %)", 100 * data.truth_error) : "exact";
}

/// Names beside strokes, in lines from the upper left; returns the height.
float draw_names(const Pen &pen, glm::vec2 corner, float width) {
    struct Name {
        std::string text;
        PlotStroke stroke;
        bool strong;
    };
    std::vector<Name> names;
    if (!pen.data.exact.empty())
        names.push_back({truth_name(pen.data), pen.truth(), false});
    for (const ProfileCurve &c : pen.data.curves)
        names.push_back({long_name(c), pen.stroke(c), true});
    if (!pen.data.crossings.empty())
        names.push_back({"discontinuity curves",
                         {curve_rgba(pen.data.crossings.front().kind), 0.08f * pen.em,
                          pen.data.crossings.front().order == 2 ? 0.3f * pen.em : 0},
                         false});
    const float swatch = 1.6f * pen.em, gap = 0.4f * pen.em, line = 1.35f * pen.em;
    glm::vec2 at = corner + glm::vec2(0, 0.6f * pen.em);
    for (const Name &n : names) {
        const PlotText words = pen.words(n.strong ? n.stroke.colour : pen.ink(0.85f), TextAlign::left, n.strong);
        const float all = swatch + gap + pen.canvas.text_width(n.text, words);
        if (at.x > corner.x && at.x + all > corner.x + width)
            at = {corner.x, at.y + line};
        pen.canvas.line(at, at + glm::vec2(swatch, 0), n.stroke);
        pen.canvas.text(at + glm::vec2(swatch + gap, 0), n.text, words);
        at.x += all + 1.2f * pen.em;
    }
    return at.y - corner.y + 0.75f * pen.em;
}

/// The numbers at the cursor, on a ground of their own beside the rule.
void draw_figures(const Pen &pen, const LinearPage &page, double cursor) {
    struct Row {
        std::string text;
        glm::vec4 colour;
    };
    std::vector<Row> rows{{fmt::format("{:.4g} from A", cursor), pen.ink(0.8f)}};
    const auto truth = point_at(pen.data.exact, cursor);
    if (truth)
        rows.push_back(
            {fmt::format("B = {:.4g}, slope {:.3g}", number(*truth, Shown::value), number(*truth, Shown::slope)),
             pen.ink()});
    for (const ProfileCurve &c : pen.data.curves)
        if (const auto p = point_at(c, cursor)) {
            std::string text =
                fmt::format("{} {:.4g}", short_name(c), number(*p, Shown::value));
            if (truth)
                text += fmt::format(" ({:+.2g})", number(*p, Shown::value) - number(*truth, Shown::value));
            rows.push_back({text + fmt::format(", slope {:.3g}", number(*p, Shown::slope)), pen.stroke(c).colour});
        }
    float width = 0;
    for (const Row &r : rows)
        width = std::max(width, pen.canvas.text_width(r.text, pen.words(r.colour)));
    const float x = page.at(cursor, page.y.low).x, line = 1.25f * pen.em, pad = 0.5f * pen.em;
    const bool on_left = x + 2 * pad + width > page.box.high.x;
    const glm::vec2 low(on_left ? x - 2 * pad - width - 0.3f * pen.em : x + 0.3f * pen.em,
                        page.box.low.y + 0.3f * pen.em);
    glm::vec4 ground = background_colour(pen.look.theme);
    ground.a = 0.88f;
    pen.canvas.fill({low, low + glm::vec2(width + 2 * pad, line * static_cast<float>(rows.size()) + pad)}, ground);
    for (std::size_t i = 0; i < rows.size(); ++i)
        pen.canvas.text(low + glm::vec2(pad, pad / 2 + line * (static_cast<float>(i) + 0.5f)), rows[i].text,
                        pen.words(rows[i].colour));
}

} // namespace

double channel_mean(const Rgb &value) { return value.mean(); }

std::optional<ProfilePoint> point_at(const std::vector<ProfilePoint> &points, double at) {
    const auto after = std::ranges::lower_bound(points, at, {}, &ProfilePoint::at);
    if (points.empty() || after == points.end())
        return std::nullopt;
    if (after == points.begin())
        return after->at == at ? std::optional(*after) : std::nullopt;
    const ProfilePoint &a = *(after - 1), &b = *after;
    const double t = (at - a.at) / (b.at - a.at);
    return ProfilePoint{at, (1 - t) * a.radiosity + t * b.radiosity, (1 - t) * a.slope + t * b.slope};
}

std::optional<ProfilePoint> point_at(const ProfileCurve &curve, double at) {
    for (const ProfilePiece &piece : curve.pieces)
        if (at >= piece.low && at <= piece.high)
            if (auto found = point_at(piece.points, std::clamp(at, piece.points.front().at, piece.points.back().at)))
                return found;
    return std::nullopt;
}

std::optional<double> ProfilePlaces::place(glm::vec2 at) const {
    if (at.x < values.low.x || at.x > values.high.x || at.y < values.low.y || at.y > slopes.high.y)
        return std::nullopt;
    return length * static_cast<double>((at.x - values.low.x) / values.width());
}

ProfilePlaces draw_profile(Canvas &canvas, const PlotBox &box, const ProfileData &data, const PlotLook &look,
                           std::optional<double> cursor) {
    const Pen pen{canvas, data, look};
    const float em = look.text, left = box.low.x + 5 * em, right = box.high.x - 0.8f * em;
    const float names = draw_names(pen, {box.low.x + 0.8f * em, box.low.y + 0.3f * em}, box.width() - 1.6f * em);
    const float row = 0.8f * em, rows = row * static_cast<float>(data.curves.size()) + 0.3f * em;
    const float top = box.low.y + names + 2.1f * em, bottom = box.high.y - 3.2f * em;
    const float between = rows + 2.1f * em, height = std::max(2 * em, bottom - top - between);
    const LinearAxis x{0, data.length > 0 ? data.length : 1};
    const LinearPage values{{{left, top}, {right, top + 0.6f * height}}, x, value_axis(data)};
    const LinearPage slopes{{{left, bottom - 0.4f * height}, {right, bottom}}, x, slope_axis(data)};
    const int n_x = labels_in(right - left, 5 * em);
    const auto axes = [&](const LinearPage &page, const std::string &title, bool last) {
        draw_axes(canvas, page.box, marks_of(page.x, "distance from A [length]", last, n_x),
                  marks_of(page.y, title, true, labels_in(page.box.height(), 2.2f * em)), look);
    };
    axes(values, "radiosity, mean of R, G, B [W/m\u00b2]", false);
    axes(slopes, "its slope [W/m\u00b2 per length]", true);
    draw_crossings(pen, values, {values.box.low.y, values.box.high.y + rows});
    draw_crossings(pen, slopes, {slopes.box.low.y, slopes.box.high.y});
    for (const auto &[page, what] : {std::pair(&values, Shown::value), std::pair(&slopes, Shown::slope)}) {
        canvas.clip(page->box);
        draw_line(pen, *page, data.exact, what, pen.truth());
        for (const ProfileCurve &c : data.curves)
            draw_solution(pen, *page, c, what);
        canvas.unclip();
    }
    draw_borders(pen, values, values.box.high.y + 0.15f * em, row);
    if (cursor) {
        const float at = values.at(*cursor, values.y.low).x;
        canvas.line({at, values.box.low.y}, {at, slopes.box.high.y}, {pen.ink(0.8f), 0.07f * em});
        draw_figures(pen, values, *cursor);
    }
    return {values.box, slopes.box, data.length};
}

void draw_profile_figure(Canvas &canvas, glm::vec2 size, const ProfileData &data, const PlotLook &look) {
    const float em = look.text;
    canvas.text({0.8f * em, 1.2f * em}, fmt::format("Radiosity along a line over {} of {}", data.surface, data.scene),
                {1.2f * em, plot_ink(look.theme), TextAlign::left, true});
    draw_profile(canvas, {{0, 2 * em}, {size.x, size.y - 2.9f * em}}, data, look);
    const PlotText note{0.9f * em, plot_ink(look.theme, 0.8f), TextAlign::left, false};
    canvas.text(
        {0.8f * em, size.y - 2.2f * em},
        "Between the plots: where the elements of each solution end. Upright lines: discontinuity curves, coloured by "
        "kind, dashed where only the curvature jumps.",
        note);
    canvas.text(
        {0.8f * em, size.y - 0.9f * em},
        fmt::format(
            "Slopes of the solutions are their polynomials' own; the true one is a difference over \u00b1{:.3g} "
            "(a thousandth of the line).",
            difference_step() * data.length),
        note);
}

} // namespace penumbra
