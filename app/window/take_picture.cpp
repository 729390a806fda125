#include "window/take_picture.h"

#include "capture.h"
#include "files/pictures_folder.h"
#include "files/state_text.h"
#include "files/write_state.h"
#include "picture_verbs.h"
#include "truth_verbs.h"
#include "window/picture_shot.h"

#include <imgui.h>

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

namespace penumbra {

namespace {

bool all_known(const AppState &state) {
    if (state.layout == Layout::difference && !errors_of(state, 1))
        return false;
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        if (!state.solution(pane))
            return false;
    return true;
}

void save(AppState &state, const std::filesystem::path &file, const Image &image, const SavedState &saved) {
    write_png(file, image, state_text(saved));
    state.last_picture = file.string();
    state.message = {"Saved " + file.string(), false};
}

void copy_command(AppState &state, int width, int height) {
    state.pictures.command = command_of(shot_of_panes(state, "", width, height), *state.scene);
    ImGui::SetClipboardText(state.pictures.command.c_str());
    state.message = {"Copied: " + state.pictures.command, false};
}

} // namespace

void take_picture(AppState &state, PictureRequest request, int width, int height) {
    if (request != PictureRequest::window && !all_known(state)) {
        state.message = {"There is nothing to take a picture of yet.", false};
        return;
    }
    try {
        if (request == PictureRequest::command) {
            copy_command(state, width, height);
            return;
        }
        const std::string given = std::exchange(state.picture_file, {});
        const std::filesystem::path file = given.empty() ? numbered_name(pictures_folder(), "penumbra") : std::filesystem::path(given);
        if (request == PictureRequest::panes) {
            const PictureShot shot = shot_of_panes(state, file.parent_path(), width, height);
            save(state, file, draw_picture(shot.spec), shot.saved);
        } else {
            save(state, file, read_pixels(0, 0, width, height), saved_state(state, file.parent_path()));
        }
    } catch (const std::exception &e) {
        state.message = {e.what(), true};
    }
}

bool take_pending_picture(AppState &state, int width, int height) {
    auto &pending = state.pictures.pending;
    if (pending.empty())
        return false;
    const PendingPicture picture = pending.front();
    const Readiness now = readiness(state, picture);
    if (now == Readiness::waiting)
        return false;
    if (now == Readiness::hopeless) {
        drop_pictures(state);
        return true;
    }
    try {
        const auto file = picture.file.empty() ? numbered_name(pictures_folder(), "penumbra") : picture.file;
        const PictureShot shot = shot_of(state, picture, file.parent_path(), width, height);
        save(state, file, draw_picture(shot.spec), shot.saved);
        pending.pop_front();
        if (pending.empty() && !picture.file.empty())
            state.message = {"Saved all steps in " + file.parent_path().string(), false};
    } catch (const std::exception &e) {
        pending.clear();
        state.message = {e.what(), true};
    }
    return true;
}

} // namespace penumbra
