// The keyhole over the panes: the point that looks, what it sees, and what the last crossing has changed.
#include "panels/controls.h"
#include "panels/panels.h"
#include "render/event_note.h"
#include "render/keyhole_inset.h"

#include <algorithm>

namespace penumbra {

namespace {

/// In the lower left corner of the pane, beside the inset.
void draw_news(const KeyholeMode &mode, ImDrawList &list, const Fonts &fonts, const Snapshot &snapshot,
               const WindowRect &pane, float inset, Theme theme) {
    if (mode.crossed < 0 || mode.crossed >= static_cast<int>(snapshot.curves->size()))
        return;
    const int kind = (*snapshot.curves)[static_cast<std::size_t>(mode.crossed)].kind;
    const float left = pane.x + em(0.6f), width = std::min(em(34), inset - left - em(0.6f));
    if (width > em(12))
        draw_event_note(&list, fonts, {left, pane.y + pane.height - em(2.2f)}, width, mode.news, curve_colour(kind),
                        theme);
}

} // namespace

void draw_keyhole(AppState &state, const Arrangement &arrangement, const Fonts &fonts) {
    const auto snapshot = state.snapshot(state.active_strategy());
    if (!state.keyhole.open || !state.keyhole.seen || state.keyhole.scene != state.scene || !snapshot)
        return;
    const Keyhole &keyhole = *state.keyhole.seen;
    const WindowRect &pane = arrangement.pane[static_cast<std::size_t>(state.panes().active)];
    const ImVec2 low{pane.x, pane.y}, high{pane.x + pane.width, pane.y + pane.height};
    ImDrawList &list = *ImGui::GetBackgroundDrawList(); // over the scene, below the panels
    draw_keyhole_point(list, fonts, low, high, state.camera, keyhole);
    const ImVec2 size = keyhole_inset_size(fonts, keyhole);
    const float top = std::max(low.y, high.y - size.y - em(0.6f));
    const float aside = !state.legend_hidden && top < low.y + em(20) ? em(5.2f) : 0; // of the colour scale
    const ImVec2 corner{std::max(low.x, high.x - size.x - em(0.6f) - aside), top};
    draw_keyhole_inset(list, fonts, corner, keyhole, *snapshot, state.look.theme);
    draw_news(state.keyhole, list, fonts, *snapshot, pane, corner.x, state.look.theme);
    state.widgets["keyhole"] = {corner.x, corner.y, size.x, size.y};
}

} // namespace penumbra
