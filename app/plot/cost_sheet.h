// What accuracy costs, as a figure: the true error against seconds, patches, coefficients and kernel evaluations, side by
// side on one scale of error, so that what looks cheap by one measure can be seen to be dear by another.
#pragma once

#include "files/cost_table.h"
#include "plot/plot.h"

#include <array>

namespace penumbra {

/// Four plots with the same y axis; the first one has its numbers and the curves' full names.
std::array<Plot, 4> cost_plots(const CostStudy &study, Theme theme);
/// What stands below them, a line each: what was measured and on what, and what the line styles and crosses mean.
std::vector<std::string> cost_notes(const CostStudy &study);
/// Fills the canvas.
void draw_cost_sheet(Canvas &canvas, glm::vec2 size, const CostStudy &study, const PlotLook &look);

} // namespace penumbra
