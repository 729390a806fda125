// The frame of a plot: grid, numbers and titles, whatever the axes' scale.
#pragma once

#include "plot/canvas.h"
#include "plot/log_axis.h"
#include "render/look.h"

#include <string>
#include <vector>

namespace penumbra {

struct PlotLook {
    float text = 15; ///< text height [pixels]; every other length is a multiple of it
    Theme theme = Theme::light;
};

/// Ticks of one axis, with where they stand on it: 0 at its low end, 1 at its high one.
struct AxisMarks {
    std::string title; ///< with the unit; of the y axis above it
    std::vector<Tick> ticks;
    std::vector<double> places;
    bool words = true; ///< numbers along it, and its title
};

/// Of an axis with place() and ticks().
template <class Axis>
AxisMarks marks_of(const Axis &axis, std::string title, bool words, int most_labels) {
    AxisMarks marks{std::move(title), ticks(axis, most_labels), {}, words};
    for (const Tick &t : marks.ticks)
        marks.places.push_back(axis.place(t.value));
    return marks;
}

/// How many labels that are `each` long fit; two at least.
int labels_in(float length, float each);
/// Around the rectangle `inside`: numbers to the left of and below it; titles beyond them.
void draw_axes(Canvas &canvas, const PlotBox &inside, const AxisMarks &x, const AxisMarks &y, const PlotLook &look);

glm::vec4 plot_ink(Theme theme, float opacity = 1);

} // namespace penumbra
