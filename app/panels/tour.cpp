// A small card in the lower right corner of the panes: what there is to see, and a button that shows it.
#include "tour.h"

#include "panels/controls.h"
#include "panels/panels.h"

#include <algorithm>
#include <string>

namespace penumbra {

namespace {

/// Where its lower right corner stands: clear of the legend, and of the keyhole's inset where that has the corner.
ImVec2 corner(const AppState &state, const Arrangement &arrangement, float width) {
    const WindowRect &panes = arrangement.panes;
    const float gap = em(0.8f), bottom = panes.y + panes.height - arrangement.legend.height - gap;
    float right = panes.x + panes.width - gap;
    if (const auto inset = state.widgets.find("keyhole"); inset != state.widgets.end()) {
        const float left = inset->second.x - gap;
        if (left < right && inset->second.x + inset->second.width > right - width && left - width > panes.x)
            right = left;
    }
    return {right, bottom};
}

/// Returns whether it was clicked.
bool button(AppState &state, const char *name, const char *text, const char *sentence, bool enabled, float width) {
    ImGui::BeginDisabled(!enabled);
    const bool clicked = ImGui::Button(text, {width, 0});
    ImGui::EndDisabled();
    mark(state, name);
    tooltip(text, sentence);
    return clicked;
}

void draw_buttons(AppState &state, int n) {
    const int card = state.tour.card;
    const float show = em(6.2f), small = em(3.6f), gap = em(0.35f);
    if (button(state, "tour.show", "Show me", "Does what the card speaks of, here and now.", can_show(state), show))
        show_card(state);
    ImGui::SameLine(0, gap);
    if (button(state, "tour.back", "Back", "The card before.", card > 0, small))
        turn_tour(state, -1);
    ImGui::SameLine(0, gap);
    if (button(state, "tour.next", "Next", "The next card.", card < n - 1, small))
        turn_tour(state, 1);
    ImGui::SameLine(0, gap);
    if (button(state, "tour.close", "Close", "Puts the cards away; they are in the Help menu.", true, small))
        state.tour.open = false;
}

} // namespace

void draw_tour(AppState &state, const Arrangement &arrangement) {
    if (!state.tour.open)
        return;
    const auto cards = tour_cards();
    const int n = static_cast<int>(cards.size());
    const TourCard &card = cards[static_cast<std::size_t>(state.tour.card)];
    const float width = std::min(em(23), arrangement.panes.width - em(1.6f));
    ImGui::SetNextWindowPos(corner(state, arrangement, width), ImGuiCond_Always, {1, 1});
    ImGui::SetNextWindowSize({width, 0});
    begin_card("tour");
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", std::string(card.title).c_str());
    const std::string count = std::to_string(state.tour.card + 1) + " of " + std::to_string(n);
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(count.c_str()).x);
    ImGui::TextDisabled("%s", count.c_str());
    ImGui::TextWrapped("%s", std::string(card.text).c_str());
    ImGui::Dummy({0, em(0.2f)});
    draw_buttons(state, n);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    state.widgets["tour"] = {low.x, low.y, size.x, size.y};
    end_card();
}

} // namespace penumbra
