#include "menu_actions.h"

#include "orphan_verbs.h"
#include "picture_verbs.h"

namespace penumbra {

std::vector<Action> file_actions() {
    return {
        {"file.open", Menu::file, "Open…",
         "Opens a scene, a saved state or a picture; a file may also be dropped on the window.", {"Ctrl+O"},
         [](AppState &s) { s.open_dialog = !s.open_dialog; }},
        {"file.state", Menu::file, "Save state", "Saves scene, options, step and view, to be opened again.", {"Ctrl+S"},
         [](AppState &s) { s.state_request = true; }, has_scene},
        {"file.picture", Menu::file, "Save picture", "Saves the panes with their labels and legend as a numbered PNG.",
         {"F12"}, [](AppState &s) { s.picture_request = PictureRequest::panes; }, has_scene},
        {"file.window_picture", Menu::file, "Save picture of the window", "Saves the whole window as a numbered PNG.",
         {"Ctrl+F12"}, [](AppState &s) { s.picture_request = PictureRequest::window; }},
        {"file.compare_picture", Menu::file, "Picture of uniform against discontinuity meshing",
         "Both side by side in the active pane's basis, at this step; what is missing is solved first.", {"Shift+F12"},
         compare_meshings, has_solution},
        {"file.sequence", Menu::file, "Pictures of all steps",
         "A numbered PNG of each step from the start to this one, in a new folder.", {"Ctrl+Shift+F12"},
         picture_all_steps, has_solution},
        {"file.picture_settings", Menu::file, "Picture settings…",
         "Size up to 8K, supersampling, transparent background, labels: of all pictures but the window's.", {},
         [](AppState &s) { s.pictures.settings_open = !s.pictures.settings_open; }},
        {"file.copy_command", Menu::file, "Copy as command",
         "Copies the 'penumbra render' line that makes the picture which Save picture would save.", {"Ctrl+Shift+C"},
         [](AppState &s) { s.picture_request = PictureRequest::command; }, has_solution},
        {"file.restore", Menu::file, "Restore what was shown", "Opens what a window showed that ended unexpectedly.", {},
         restore_orphan, has_orphan, nullptr, nullptr, true},
        {"file.discard", Menu::file, "Discard what was shown",
         "Deletes what was kept of a window that ended unexpectedly.", {}, discard_orphan, has_orphan, nullptr, nullptr, true},
        {"file.quit", Menu::file, "Quit", "Closes the window.", {"Ctrl+Q"}, [](AppState &s) { s.quit_request = true; }},
    };
}

} // namespace penumbra
