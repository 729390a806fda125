// Over the panes: a line to type in, and what it finds.
#include "palette.h"

#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/shortened.h"

#include <algorithm>

namespace penumbra {

namespace {

constexpr std::size_t longest_search = 128;
constexpr int lines_shown = 12;

void draw_entry(AppState &state, const PaletteEntry &entry, bool chosen) {
    ImGui::BeginDisabled(!entry.enabled);
    const bool clicked = ImGui::Selectable(("##" + entry.title + entry.help).c_str(), chosen);
    mark(state, "palette." + (entry.action ? std::string(entry.action->id) : entry.file));
    ImGui::SameLine(em(0.3f));
    ImGui::TextUnformatted(entry.title.c_str());
    ImGui::SameLine();
    const float right = ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(entry.key.c_str()).x;
    ImGui::TextDisabled("%s", shortened(entry.help, right - em(0.5f) - ImGui::GetCursorPosX()).c_str());
    ImGui::SameLine(right);
    ImGui::TextUnformatted(entry.key.c_str());
    ImGui::EndDisabled();
    if (clicked && entry.enabled)
        choose(state, entry);
    if (chosen && !ImGui::IsItemVisible())
        ImGui::SetScrollHereY();
}

void move_choice(PaletteMode &palette, int n) {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow)))
        ++palette.chosen;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow)))
        --palette.chosen;
    palette.chosen = std::clamp(palette.chosen, 0, std::max(0, n - 1));
}

} // namespace

void draw_palette(AppState &state) {
    if (!state.palette.open)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = std::min(em(44), window.x - em(2));
    ImGui::SetNextWindowPos({0.5f * window.x, 0.12f * window.y}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::Begin("palette", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::IsWindowAppearing())
        ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    std::string typed = state.palette.typed;
    typed.resize(longest_search);
    const bool entered = ImGui::InputTextWithHint("##typed", "What do you want to do?", typed.data(), longest_search,
                                                  ImGuiInputTextFlags_EnterReturnsTrue);
    typed.resize(typed.find('\0'));
    mark(state, "palette");
    if (typed != state.palette.typed) {
        state.palette.typed = typed;
        state.palette.chosen = 0;
    }
    const auto entries = palette_entries(state, typed);
    move_choice(state.palette, static_cast<int>(entries.size()));
    const float line = ImGui::GetTextLineHeightWithSpacing();
    ImGui::BeginChild("found", {0, line * static_cast<float>(std::clamp<std::size_t>(entries.size(), 1, lines_shown))});
    if (entries.empty())
        ImGui::TextDisabled("nothing of that name");
    for (std::size_t i = 0; i < entries.size() && state.palette.open; ++i)
        draw_entry(state, entries[i], static_cast<int>(i) == state.palette.chosen);
    ImGui::EndChild();
    if (!entries.empty()) { // whole, where the line above has no room for it
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("%s", entries[static_cast<std::size_t>(state.palette.chosen)].help.c_str());
        ImGui::PopTextWrapPos();
    }
    if (entered && state.palette.open && !entries.empty() &&
        entries[static_cast<std::size_t>(state.palette.chosen)].enabled)
        choose(state, entries[static_cast<std::size_t>(state.palette.chosen)]);
    ImGui::End();
}

} // namespace penumbra
