// The views that are come back to, in their order, each with its caption.
#include "bookmark_verbs.h"
#include "panels/controls.h"
#include "panels/panels.h"

#include <string>

namespace penumbra {

namespace {

constexpr std::size_t longest_caption = 1024;

/// Returns whether it was taken away.
bool draw_bookmark(AppState &state, int number) {
    SavedState &view = state.bookmarks[static_cast<std::size_t>(number)];
    const std::string id = std::to_string(number + 1);
    if (choice(state, "bookmark " + id, id.c_str(), state.bookmark == number, "Shows this view again.", {em(2), 0}))
        go_to_bookmark(state, number);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-em(2.6f));
    std::string caption = view.caption;
    caption.resize(longest_caption);
    if (ImGui::InputText(("##caption" + id).c_str(), caption.data(), longest_caption)) {
        caption.resize(caption.find('\0'));
        view.caption = caption;
        if (state.bookmark == number)
            state.caption = caption;
    }
    mark(state, "caption " + id);
    tooltip("Caption", "Stands below the panes, in the window and in pictures.");
    ImGui::SameLine();
    const bool gone = ImGui::Button(("\u00d7##" + id).c_str(), {-1, 0});
    mark(state, "no bookmark " + id);
    tooltip("Take it away", "The view itself is not changed.");
    ImGui::TextDisabled("%s, step %d", view.scene.c_str(), iteration_of(view.position));
    return gone;
}

} // namespace

void draw_bookmarks(AppState &state) {
    heading("Bookmarks");
    if (state.bookmarks.empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled("Ctrl+B keeps what is shown; Page Down and Page Up, or a clicker, go from one to the next. They are "
                            "kept in the saved state.");
        ImGui::PopTextWrapPos();
    }
    for (int i = 0; i < static_cast<int>(state.bookmarks.size()); ++i)
        if (draw_bookmark(state, i)) {
            remove_bookmark(state, i);
            break;
        }
    action_button(state, "view.bookmark");
}

} // namespace penumbra
