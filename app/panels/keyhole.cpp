// The keyhole over the panes: the point that looks, what it sees, and what the last crossing has changed.
#include "panels/controls.h"
#include "panels/panels.h"
#include "render/event_note.h"
#include "render/keyhole_inset.h"

#include <algorithm>

namespace penumbra {

namespace {

/// In the lower left corner of the pane, up to `right`.
void draw_news(const AppState &state, ImDrawList &list, const Fonts &fonts, const Snapshot &snapshot,
               const WindowRect &pane, float right) {
    const KeyholeMode &mode = state.keyhole;
    if (mode.crossed < 0 || mode.crossed >= static_cast<int>(snapshot.curves->size()))
        return;
    const int kind = (*snapshot.curves)[static_cast<std::size_t>(mode.crossed)].kind;
    const float left = pane.x + em(0.6f), width = std::min(em(34), right - left - em(0.6f));
    if (width > em(12))
        draw_event_note(&list, fonts, {left, pane.y + pane.height - em(2.2f)}, width, mode.news, curve_colour(kind),
                        state.look.theme);
}

/// In the lower right corner of the pane, clear of the colour scale.
ImVec2 inset_corner(const AppState &state, const WindowRect &pane, bool has_scale, ImVec2 size) {
    const float right = pane.x + pane.width - em(0.6f);
    const float top = std::max(pane.y, pane.y + pane.height - size.y - em(0.6f));
    const bool in_the_way = has_scale && !state.legend_hidden && top < pane.y + em(20);
    return {std::max(pane.x, right - size.x - (in_the_way ? em(5.2f) : 0)), top};
}

} // namespace

void draw_keyhole(AppState &state, ImDrawList &list, const Arrangement &arrangement, const Fonts &fonts) {
    const auto snapshot = state.active_solution();
    if (!state.keyhole.open || !state.keyhole.seen || state.keyhole.scene != state.scene || !snapshot)
        return;
    const Keyhole &keyhole = *state.keyhole.seen;
    for (std::size_t i = 0; i < arrangement.place.size(); ++i) {
        const WindowRect &pane = arrangement.place[i];
        draw_keyhole_point(list, fonts, {pane.x, pane.y}, {pane.x + pane.width, pane.y + pane.height},
                           state.camera_of(static_cast<int>(i)), keyhole);
    }
    // Beside the active pane rather than over it.
    const bool alone = arrangement.place.size() == 1;
    const auto active = static_cast<std::size_t>(state.panes().active), host = alone ? active : active ^ 1;
    const ImVec2 size = keyhole_inset_size(fonts, keyhole);
    const ImVec2 corner = inset_corner(state, arrangement.pane[host], alone || host == 1, size);
    draw_keyhole_inset(list, fonts, corner, keyhole, *snapshot, state.look.theme);
    const WindowRect &pane = arrangement.pane[active];
    draw_news(state, list, fonts, *snapshot, pane, alone ? corner.x : pane.x + pane.width);
    state.widgets["keyhole"] = {corner.x, corner.y, size.x, size.y};
}

} // namespace penumbra
