// A log-log plot, drawn on any canvas.
#pragma once

#include "plot/axes.h"

#include <string>
#include <vector>

namespace penumbra {

struct PlotMark {
    double x = 0, y = 0;
    double x_low = 0, x_high = 0; ///< spread of x, drawn as whiskers; equal: none
    bool hollow = false;          ///< with a reservation
    bool ringed = false;          ///< where we stand
};

struct PlotCurve {
    glm::vec4 colour{0, 0, 0, 1}; ///< sRGB
    PlotMarker marker = PlotMarker::circle;
    bool dashed = false;
    bool joined = true;          ///< by a line
    std::string label;           ///< beside the curve; empty: none
    std::vector<PlotMark> marks; ///< in the order in which they are joined
    /// Runs that never came to be a mark, as crosses on the right border: their y, or one that is not positive where it
    /// is not known (the cross stands in the upper right corner then).
    std::vector<double> stopped;
};

struct Plot {
    std::string x_title, y_title; ///< with the unit; the latter stands above the axis
    LogAxis x, y;
    bool y_words = true; ///< numbers along the y axis
    std::vector<PlotCurve> curves;
};

/// Where a mark, or a cross, was drawn.
struct PlacedMark {
    std::size_t curve = 0, index = 0; ///< of plot.curves, and of its marks or its stopped ones
    bool stopped = false;
    glm::vec2 at{0};
};

/// The rectangle between the axes when the plot fills `box`.
PlotBox inside_axes(const PlotBox &box, const Plot &plot, const PlotLook &look);
/// Fills `box`.
std::vector<PlacedMark> draw_plot(Canvas &canvas, const PlotBox &box, const Plot &plot, const PlotLook &look);

/// The mark nearest to a point of the page, at most `reach` away; null when there is none.
const PlacedMark *mark_near(const std::vector<PlacedMark> &marks, glm::vec2 at, float reach);

} // namespace penumbra
