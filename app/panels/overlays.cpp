// What stands over the panes for a while: the first hint, and what went wrong.
#include "panels/controls.h"
#include "panels/panels.h"

namespace penumbra {

namespace {

/// A rounded box over the panes, centred at the given height (0 top, 1 bottom).
void draw_chip(const char *name, const WindowRect &panes, float at, const char *text, ImVec4 background, ImVec4 colour) {
    const float wrap = std::min(panes.width - em(4), em(46));
    const ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, wrap);
    const ImVec2 pad{em(0.9f), em(0.5f)};
    ImGui::SetNextWindowPos({panes.x + 0.5f * (panes.width - size.x) - pad.x,
                             panes.y + at * (panes.height - size.y - 2 * pad.y)});
    ImGui::SetNextWindowSize({size.x + 2 * pad.x + 1, size.y + 2 * pad.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, em(0.5f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, pad);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(wrap + pad.x + 1);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::End();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
}

} // namespace

void draw_hint(AppState &state, const WindowRect &panes) {
    if (state.hint_done || state.tour.open || state.message.error || state.keyhole.open || state.pinned_curve)
        return;
    draw_chip("hint", panes, 0.86f, "Press \u2192 for the first step, Space to play.  ? shows every key.",
              {0.93f, 0.76f, 0.38f, 0.95f}, {0.08f, 0.07f, 0.05f, 1});
}

void draw_caption(const AppState &state, const WindowRect &panes) {
    if (!state.caption.empty())
        draw_chip("caption", panes, 0.88f, state.caption.c_str(), {0.10f, 0.11f, 0.13f, 0.92f}, {1, 1, 1, 1});
}

void draw_error(AppState &state, const WindowRect &panes) {
    if (state.message.error)
        draw_chip("error", panes, 0.12f, state.message.text.c_str(), {0.55f, 0.13f, 0.10f, 0.96f}, {1, 0.96f, 0.94f, 1});
}

} // namespace penumbra
