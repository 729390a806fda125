#include "files/recent_files.h"
#include "panels/controls.h"
#include "panels/panels.h"

#include <string>

namespace penumbra {

namespace {

void draw_item(AppState &state, const Action &action) {
    const std::string title(action.title), key(action.keys.empty() ? "" : action.keys.front());
    if (ImGui::MenuItem(title.c_str(), key.c_str(), is_checked(action, state), is_enabled(action, state)))
        choose(action, state);
    mark(state, "menu." + std::string(action.id));
    tooltip(title, action.help, {}, action.paper);
}

/// Those of the recent files that are still there.
void draw_recent(AppState &state) {
    const RecentFiles files = that_exist(state.recent_files);
    const bool open = ImGui::BeginMenu("Open recent", !files.empty());
    if (!open) {
        mark(state, "menu.recent");
        tooltip("Open recent", "Scenes, states and pictures that were opened lately.");
        return;
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::filesystem::path file(files[i]);
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::MenuItem(file.filename().c_str()))
            state.open_request = files[i];
        mark(state, "menu.recent " + std::to_string(i));
        tooltip(file.filename(), "In " + file.parent_path().string());
        ImGui::PopID();
    }
    ImGui::EndMenu();
}

} // namespace

void draw_menu_bar(AppState &state) {
    if (!ImGui::BeginMainMenuBar())
        return;
    for (const Menu menu : {Menu::file, Menu::edit, Menu::solve, Menu::strategy, Menu::view, Menu::layers, Menu::help}) {
        const std::string name(title(menu));
        const bool open = ImGui::BeginMenu(name.c_str());
        if (!open) {
            mark(state, "menu." + name);
            continue;
        }
        for (const Action &action : actions())
            if (action.menu == menu && is_offered(action, state)) {
                draw_item(state, action);
                if (action.id == "file.open")
                    draw_recent(state);
            }
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
}

} // namespace penumbra
