#include "panels/controls.h"
#include "panels/panels.h"

namespace penumbra {

namespace {

void row(std::string_view keys, std::string_view sentence) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
    ImGui::PopTextWrapPos();
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%.*s", static_cast<int>(sentence.size()), sentence.data());
    ImGui::PopTextWrapPos();
}

void begin_block(const char *name) {
    heading(name);
    ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingFixedFit);
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, em(7.9f));
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
}

void draw_mouse() {
    begin_block("Mouse");
    row("drag", "Turns about the point under the mouse, or about the pivot.");
    row("right drag", "Moves along; also with the middle button, or Shift and the left one.");
    row("wheel", "Up: nearer to the point under the mouse. Down: away from it.");
    row("click", "On a curve: keeps its critical surface in sight. Elsewhere, or Esc: lets it go. "
                 "With the filter microscope or the inspector open, on a patch: shows its filters, or all about it.");
    row("keyhole drag", "On a surface, the keyhole open: moves the point that looks. Elsewhere: turns, as ever.");
    row("divider drag", "In a wipe: shows more of one strategy and less of the other.");
    row("double click", "Makes the point under the mouse the pivot.");
    ImGui::EndTable();
}

void draw_menu(Menu menu) {
    const std::string name(title(menu));
    begin_block(name.c_str());
    for (const Action &action : actions())
        if (action.menu == menu && !action.keys.empty())
            row(action.keys.front(), action.help);
    ImGui::EndTable();
}

} // namespace

void draw_help(AppState &state) {
    if (!state.help_open)
        return;
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
    const float width = std::min(em(78), window.x - em(2));
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, window.y - em(1)}); // beyond that it scrolls
    ImGui::SetNextWindowSize({width, 0});
    ImGui::Begin("Keys and mouse", &state.help_open,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    if (ImGui::BeginTable("columns", 2, ImGuiTableFlags_SizingStretchSame)) {
        ImGui::TableNextColumn();
        draw_mouse();
        draw_menu(Menu::solve);
        draw_menu(Menu::strategy);
        draw_menu(Menu::file);
        draw_menu(Menu::edit);
        ImGui::TableNextColumn();
        draw_menu(Menu::layers);
        draw_menu(Menu::view);
        ImGui::EndTable();
    }
    ImGui::End();
}

} // namespace penumbra
