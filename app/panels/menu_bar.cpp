#include "panels/controls.h"
#include "panels/panels.h"

#include <string>

namespace penumbra {

namespace {

void draw_item(AppState &state, const Action &action) {
    const std::string title(action.title), key(action.keys.empty() ? "" : action.keys.front());
    if (ImGui::MenuItem(title.c_str(), key.c_str(), is_checked(action, state), is_enabled(action, state)))
        run(action, state);
    mark(state, "menu." + std::string(action.id));
    tooltip(title, action.help);
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
            if (action.menu == menu)
                draw_item(state, action);
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
}

} // namespace penumbra
