#include "plot/strategy_style.h"

#include <array>

namespace penumbra {

namespace {

constexpr std::array<std::array<int, 3>, 4> bright{{
    {0x44, 0x77, 0xaa}, // blue
    {0xee, 0x66, 0x77}, // red
    {0x22, 0x88, 0x33}, // green
    {0xaa, 0x33, 0x77}, // purple
}};

} // namespace

glm::vec4 strategy_colour(Strategy strategy, Theme theme) {
    const auto &c = bright[static_cast<std::size_t>(strategy)];
    const glm::vec4 colour(static_cast<float>(c[0]) / 255, static_cast<float>(c[1]) / 255,
                           static_cast<float>(c[2]) / 255, 1);
    return theme == Theme::light ? colour : glm::mix(colour, glm::vec4(1), 0.35f); // on a dark ground
}

PlotMarker strategy_marker(Strategy strategy) {
    constexpr PlotMarker shapes[] = {PlotMarker::circle, PlotMarker::square, PlotMarker::triangle, PlotMarker::diamond};
    return shapes[static_cast<std::size_t>(strategy)];
}

std::string strategy_label(Strategy strategy, int order) {
    const std::string letter(1, "abcd"[static_cast<std::size_t>(strategy)]);
    return "(" + letter + ") " + (cuts_along_curves(strategy) ? "cut, " : "uniform, ") +
           (is_constant(strategy) ? "constant" : "M = " + std::to_string(order));
}

} // namespace penumbra
