#include "plot/strategy_style.h"

#include <array>

namespace penumbra {

namespace {

/// 0xrrggbb, by theme and strategy: blue, yellow, magenta, violet.
constexpr std::array<std::array<unsigned, 4>, 2> colours{{
    {0x5c8af0, 0xe5dc6a, 0xf0609f, 0xc4b5ff}, // on the dark ground
    {0x5a86f0, 0x94942e, 0xdc267f, 0x332288}, // on paper
}};

} // namespace

glm::vec4 strategy_colour(Strategy strategy, Theme theme) {
    const unsigned c = colours[static_cast<std::size_t>(theme)][static_cast<std::size_t>(strategy)];
    const auto channel = [&](unsigned shift) { return static_cast<float>((c >> shift) & 0xffU) / 255; };
    return {channel(16), channel(8), channel(0), 1};
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
