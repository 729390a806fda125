#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "picture_verbs.h"
#include "truth_verbs.h"

#include <algorithm>
#include <cstdio>

namespace penumbra {

namespace {

std::string facts(const AppState &state) {
    std::string text;
    if (const auto difference = difference_under_cursor(state))
        text = "difference " + number_words(difference->mean()) + " W/m²   ";
    else if (state.under_cursor)
        text = rgb_words(state.under_cursor->radiosity) + " W/m²   ";
    char exposure[32];
    std::snprintf(exposure, sizeof exposure, "%+.1f EV   ", state.look.exposure_ev);
    return text + exposure + position_words(state.shown_position());
}

} // namespace

void draw_status_bar(AppState &state, const WindowRect &rect) {
    begin_panel("status", rect);
    const std::string progress = picture_progress(state);
    const std::string right = facts(state);
    const float place = std::max(em(1), ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(right.c_str()).x);
    const std::string whole = !progress.empty() ? progress : state.message.error ? "" : state.message.text;
    text_that_fits(state, whole, place - em(1.5f), "message", "What just happened");
    ImGui::SameLine(place);
    ImGui::TextDisabled("%s", right.c_str());
    ImGui::End();
}

} // namespace penumbra
