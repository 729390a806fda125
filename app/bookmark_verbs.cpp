#include "bookmark_verbs.h"

#include "files/state_text.h"
#include "move_verbs.h"
#include "restore.h"
#include "scene/obj_header.h"
#include "verbs.h"

#include <fmt/format.h>

#include <utility>

namespace penumbra {

namespace {

std::string usual_caption(const AppState &state) {
    std::string panes;
    for (const Strategy s : state.shown())
        panes += (panes.empty() ? "(" : ", (") + std::string(letter(s)) + ")";
    return state.scene->name + ", step " + std::to_string(iteration_of(state.shown_position())) + ": " + panes;
}

bool is_of(const SavedState &saved, const Scene &scene) {
    return saved.scene == scene.name && saved.file == place_of(scene, "/");
}

} // namespace

void add_bookmark(AppState &state) {
    if (!state.scene)
        return;
    SavedState view = saved_state(state, "/");
    view.bookmarks.clear();
    if (view.caption.empty())
        view.caption = usual_caption(state);
    state.bookmark = std::min(state.bookmark + 1, static_cast<int>(state.bookmarks.size()));
    state.message = {"Bookmark " + std::to_string(state.bookmark + 1) + ": " + view.caption, false};
    state.bookmarks.insert(state.bookmarks.begin() + state.bookmark, std::move(view));
}

void go_to_bookmark(AppState &state, int number) {
    if (number < 0 || number >= static_cast<int>(state.bookmarks.size()))
        return;
    state.bookmark = number;
    const SavedState view = state.bookmarks[static_cast<std::size_t>(number)];
    state.playing = false;
    state.halted = false;
    if (!state.scene || !is_of(view, *state.scene)) {
        state.open_request = view.file.empty() ? view.scene : view.file;
        state.to_restore = view;
        return;
    }
    bring_back(state, view);
}

void remove_bookmark(AppState &state, int number) {
    if (number < 0 || number >= static_cast<int>(state.bookmarks.size()))
        return;
    state.bookmarks.erase(state.bookmarks.begin() + number);
    state.bookmark = std::min(state.bookmark, static_cast<int>(state.bookmarks.size()) - 1);
}

std::string view_text(const Camera &c) {
    return fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}", c.eye.x, c.eye.y, c.eye.z, c.target.x, c.target.y,
                       c.target.z, c.fov_y);
}

void use_view_text(AppState &state, const std::string &text) {
    const auto view = view_from(text);
    if (!view || !state.scene) {
        state.message = {"The clipboard holds no view; Ctrl+C copies one.", false};
        return;
    }
    state.camera_of(state.panes().active) = camera_from(*view, *state.scene);
    state.camera_is_set = state.camera_moved = true;
    state.pivot.reset();
    state.message = {"The view of the clipboard.", false};
}

} // namespace penumbra
