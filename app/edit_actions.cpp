#include "menu_actions.h"

#include "bookmark_verbs.h"
#include "history.h"
#include "move_verbs.h"

namespace penumbra {

std::vector<Action> edit_actions() {
    return {
        {"edit.undo", Menu::edit, "Undo", "Takes back the last change of a parameter or of the view.", {"Ctrl+Z"}, undo, can_undo},
        {"edit.redo", Menu::edit, "Redo", "Does again what was undone.", {"Ctrl+Y", "Ctrl+Shift+Z"}, redo, can_redo},
        {"edit.copy_view", Menu::edit, "Copy view", "The eye, its target and the angle, as text that --view takes.", {"Ctrl+C"},
         [](AppState &s) {
             s.copy_request = view_text(s.active_camera());
             s.message = {"Copied: " + *s.copy_request, false};
         },
         has_scene},
        {"edit.paste_view", Menu::edit, "Paste view", "Looks as the view in the clipboard does.", {"Ctrl+V"},
         [](AppState &s) { s.paste_request = true; }, has_scene},
        {"edit.put_back", Menu::edit, "Put objects back", "Everything that was moved goes where the file has it.", {"Shift+O"},
         put_objects_back, [](const AppState &s) { return !s.objects.moves.empty(); }},
        {"edit.palette", Menu::edit, "Find an action…", "Everything that can be done, found by typing a part of its name.",
         {"Ctrl+K"}, [](AppState &s) { s.palette = {!s.palette.open, {}, 0}; }, nullptr,
         [](const AppState &s) { return s.palette.open; }},
    };
}

} // namespace penumbra
