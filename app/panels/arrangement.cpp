#include "panels/arrangement.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace penumbra {

namespace {
std::vector<WindowRect> split(const WindowRect &area, int columns, int rows, float gap) {
    std::vector<WindowRect> panes;
    const float w = std::floor((area.width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    const float h = std::floor((area.height - gap * static_cast<float>(rows - 1)) / static_cast<float>(rows));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            panes.push_back({area.x + static_cast<float>(column) * (w + gap),
                             area.y + static_cast<float>(row) * (h + gap), std::max(1.f, w), std::max(1.f, h)});
    return panes;
}

std::pair<WindowRect, WindowRect> cut_at(const WindowRect &area, double share) {
    WindowRect left = area, right = area;
    left.width = std::round(static_cast<float>(share) * area.width);
    right.x += left.width;
    right.width -= left.width;
    return {left, right};
}
} // namespace

bool is_narrow(float width, float em) { return width < 54 * em; }

Arrangement arrange(const AppState &state, float width, float height, float top, float em,
                    const std::function<float(float)> &legend_height) {
    Arrangement a;
    WindowRect rest{0, 0, width, height};
    if (!state.panels_hidden) {
        const float bar = std::round((0.45f + 1.85f * static_cast<float>(state.tool_bar_rows)) * em),
                    transport = std::round((is_narrow(width, em) ? 6.2f : 3.5f) * em), status = std::round(1.75f * em);
        const float side = std::min(std::round(16.5f * em), std::floor(0.35f * width));
        a.tool_bar = {0, top, width, bar};
        a.status = {0, height - status, width, status};
        a.transport = {0, a.status.y - transport, width, transport};
        // In a narrow window one panel stands beside the panes.
        const bool gives_way = is_narrow(width, em) && state.inspector != Inspector::none;
        a.side = {0, top + bar, gives_way ? 0 : side, a.transport.y - top - bar};
        rest = {a.side.width, top + bar, width - a.side.width, a.side.height};
        if (state.inspector != Inspector::none) {
            const float inspector = std::min(std::round(25 * em), std::floor(0.5f * rest.width));
            rest.width -= inspector;
            a.inspector = {width - inspector, rest.y, inspector, rest.height};
        }
    }
    rest.width = std::max(1.f, rest.width);
    rest.height = std::max(1.f, rest.height);
    if (state.profile.open && !state.panels_hidden) {
        const float plot = std::min(std::round(24 * em), std::floor(0.55f * rest.height));
        rest.height = std::max(1.f, rest.height - plot);
        a.profile = {rest.x, rest.y + rest.height, rest.width, plot};
    }
    a.panes = rest;
    WindowRect scene = rest;
    if (!state.legend_hidden) {
        const float needed = legend_height(rest.width - 1.6f * em) + 0.8f * em;
        const float strip = std::round(std::clamp(needed, 1.9f * em, 0.4f * rest.height));
        a.legend = {rest.x, rest.y + rest.height - strip, rest.width, strip};
        scene.height = std::max(1.f, rest.height - strip);
    }
    const int columns = n_places(state.layout) == 1 ? 1 : 2, rows = n_places(state.layout) == 4 ? 2 : 1;
    a.place = split(scene, columns, rows, 2);
    a.pane = share_a_place(state.layout) ? std::vector(static_cast<std::size_t>(n_panes(state.layout)), scene) : a.place;
    a.part = a.pane;
    if (state.layout == Layout::wipe)
        std::tie(a.part[0], a.part[1]) = cut_at(scene, state.wipe);
    else if (state.layout == Layout::difference)
        a.part[0].width = 0;
    else if (state.layout == Layout::flip)
        a.part[static_cast<std::size_t>(1 - state.panes().active)].width = 0;
    return a;
}

} // namespace penumbra
