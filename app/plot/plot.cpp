#include "plot/plot.h"

#include "plot/label_places.h"

#include <algorithm>

namespace penumbra {

namespace {

/// From values to the page.
struct Page {
    PlotBox box;
    const Plot &plot;

    float x(double value) const { return box.low.x + static_cast<float>(plot.x.place(value)) * box.width(); }
    float y(double value) const { return box.high.y - static_cast<float>(plot.y.place(value)) * box.height(); }
    glm::vec2 at(const PlotMark &m) const { return {x(m.x), y(m.y)}; }
    glm::vec2 at_stopped(double value) const {
        return {box.high.x, value > 0 ? std::clamp(y(value), box.low.y, box.high.y) : box.low.y};
    }
};

struct Pen {
    Canvas &canvas;
    const PlotLook &look;
    float em = look.text;

    PlotStroke stroke(const glm::vec4 &colour, float width, float dash = 0) const {
        return {colour, width * em, dash * em};
    }
    PlotText label(const PlotCurve &curve) const { return {em, glm::vec4(glm::vec3(curve.colour), 1), TextAlign::centre, true}; }
};

void draw_curve(const Pen &pen, const Page &page, const PlotCurve &curve) {
    std::vector<glm::vec2> line; // a piece without length has no direction, which some back ends need
    for (const PlotMark &m : curve.marks)
        if (const glm::vec2 p = page.at(m); line.empty() || glm::distance(line.back(), p) > 0.01f)
            line.push_back(p);
    if (curve.joined && line.size() > 1)
        pen.canvas.polyline(line, pen.stroke(curve.colour, 0.11f, curve.dashed ? 0.45f : 0));
    const PlotStroke thin = pen.stroke(curve.colour, 0.08f);
    for (const PlotMark &m : curve.marks) {
        const glm::vec2 at = page.at(m);
        if (m.x_high > m.x_low && m.x_low > 0) {
            const float low = page.x(m.x_low), high = page.x(m.x_high), cap = 0.22f * pen.em;
            pen.canvas.line({low, at.y}, {high, at.y}, thin);
            pen.canvas.line({low, at.y - cap}, {low, at.y + cap}, thin);
            pen.canvas.line({high, at.y - cap}, {high, at.y + cap}, thin);
        }
        glm::vec4 ground = background_colour(pen.look.theme);
        pen.canvas.marker(at, curve.marker, 0.28f * pen.em, thin, m.hollow ? ground : curve.colour);
        if (m.ringed)
            pen.canvas.marker(at, PlotMarker::circle, 0.62f * pen.em, pen.stroke(plot_ink(pen.look.theme), 0.1f),
                              glm::vec4(0));
    }
    for (const double y : curve.stopped)
        pen.canvas.marker(page.at_stopped(y), PlotMarker::cross, 0.36f * pen.em, pen.stroke(curve.colour, 0.16f),
                          glm::vec4(0));
}

/// What labels should not cover: marks, crosses, and points along the curves.
std::vector<glm::vec2> taken_points(const Page &page) {
    constexpr int n = 12; // points of a piece, and what a cross weighs, which nobody would look for below a label
    std::vector<glm::vec2> taken;
    for (const PlotCurve &curve : page.plot.curves) {
        for (std::size_t i = 0; i < curve.marks.size(); ++i) {
            const glm::vec2 b = page.at(curve.marks[i]), a = i > 0 ? page.at(curve.marks[i - 1]) : b;
            for (int k = 1; k <= n; ++k)
                taken.push_back(glm::mix(a, b, static_cast<float>(k) / n));
        }
        for (const double y : curve.stopped)
            taken.insert(taken.end(), n, page.at_stopped(y));
    }
    return taken;
}

void draw_labels(const Pen &pen, const Page &page) {
    std::vector<LabelWish> wishes;
    for (const PlotCurve &curve : page.plot.curves) {
        LabelWish wish;
        for (const PlotMark &m : curve.marks)
            wish.anchors.push_back(page.at(m));
        if (curve.marks.empty() && !curve.stopped.empty())
            wish.anchors.push_back(page.at_stopped(curve.stopped.front()));
        if (!curve.label.empty())
            wish.width = pen.canvas.text_width(curve.label, pen.label(curve)) + 0.3f * pen.em;
        wishes.push_back(std::move(wish));
    }
    const std::vector<PlotBox> boxes = place_labels(page.box, wishes, taken_points(page), 1.15f * pen.em);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const PlotBox &b = boxes[i];
        if (b.width() <= 0)
            continue;
        glm::vec4 ground = background_colour(pen.look.theme);
        ground.a = 0.75f;
        pen.canvas.fill(b, ground);
        pen.canvas.text((b.low + b.high) / 2.f, page.plot.curves[i].label, pen.label(page.plot.curves[i]));
    }
}

} // namespace

PlotBox inside_axes(const PlotBox &box, const Plot &plot, const PlotLook &look) {
    const float em = look.text;
    return {box.low + glm::vec2((plot.y_words ? 4.4f : 0.8f) * em, 2 * em), box.high - glm::vec2(0.8f * em, 3.2f * em)};
}

std::vector<PlacedMark> draw_plot(Canvas &canvas, const PlotBox &box, const Plot &plot, const PlotLook &look) {
    const Page page{inside_axes(box, plot, look), plot};
    const Pen pen{canvas, look};
    const float em = look.text;
    draw_axes(canvas, page.box, marks_of(plot.x, plot.x_title, true, labels_in(page.box.width(), 4.5f * em)),
              marks_of(plot.y, plot.y_title, plot.y_words, labels_in(page.box.height(), 1.8f * em)), look);
    std::vector<PlacedMark> placed;
    for (std::size_t c = 0; c < plot.curves.size(); ++c) {
        const PlotCurve &curve = plot.curves[c];
        draw_curve(pen, page, curve);
        for (std::size_t i = 0; i < curve.marks.size(); ++i)
            placed.push_back({c, i, false, page.at(curve.marks[i])});
        for (std::size_t i = 0; i < curve.stopped.size(); ++i)
            placed.push_back({c, i, true, page.at_stopped(curve.stopped[i])});
    }
    draw_labels(pen, page);
    return placed;
}

const PlacedMark *mark_near(const std::vector<PlacedMark> &marks, glm::vec2 at, float reach) {
    const PlacedMark *nearest = nullptr;
    for (const PlacedMark &m : marks)
        if (const float d = glm::distance(m.at, at); d <= reach) {
            reach = d;
            nearest = &m;
        }
    return nearest;
}

} // namespace penumbra
