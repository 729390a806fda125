// How the four strategies and the two bases look in plots: the same everywhere.
#pragma once

#include "core/options.h"
#include "plot/canvas.h"
#include "render/look.h"

#include <string>

namespace penumbra {

/// Told apart with each kind of colour blindness (tests/plot/colours_test.cpp simulates them). sRGB.
glm::vec4 strategy_colour(Strategy strategy, Theme theme);
PlotMarker strategy_marker(Strategy strategy);
/// "(d) cut, M = 4"; for labels that stand in a plot.
std::string strategy_label(Strategy strategy, int order);
/// Planar lines are dashed.
constexpr bool is_dashed(BasisFamily basis) { return basis == BasisFamily::planar; }

} // namespace penumbra
