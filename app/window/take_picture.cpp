#include "window/take_picture.h"

#include "capture.h"
#include "files/pictures_folder.h"
#include "files/state_text.h"
#include "files/write_state.h"
#include "picture_verbs.h"
#include "truth_verbs.h"

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

Photographer::InHand::InHand(PictureShot shot, std::filesystem::path f, bool w)
    : drawing(shot.spec), file(std::move(f)), saved(std::move(shot.saved)), waited(w) {}

void Photographer::take(AppState &state, PictureRequest request, int width, int height) {
    if (request != PictureRequest::window && !all_known(state)) {
        state.message = {"There is nothing to take a picture of yet.", false};
        return;
    }
    const std::string given = std::exchange(state.picture_file, {});
    if (request == PictureRequest::panes && in_hand_) {
        state.message = {"The picture before is still being drawn; Esc gives it up.", true};
        return;
    }
    try {
        if (request == PictureRequest::command) {
            copy_command(state, width, height);
            return;
        }
        const std::filesystem::path file = given.empty() ? numbered_name(pictures_folder(), "penumbra") : std::filesystem::path(given);
        if (request == PictureRequest::window) {
            save(state, file, read_pixels(0, 0, width, height), saved_state(state, file.parent_path()));
            return;
        }
        in_hand_.emplace(shot_of_panes(state, file.parent_path(), width, height), file, false);
        draw(state);
    } catch (const std::exception &e) {
        in_hand_.reset();
        state.message = {e.what(), true};
    }
}

/// The next tile, and the file after the last one.
void Photographer::draw(AppState &state) {
    in_hand_->drawing.draw_tile();
    state.pictures.drawn = in_hand_->drawing.share();
    if (*state.pictures.drawn < 1)
        return;
    state.pictures.drawn.reset();
    auto &pending = state.pictures.pending;
    const bool is_step = in_hand_->waited && !pending.front().file.empty();
    save(state, in_hand_->file, std::move(in_hand_->drawing).take(), in_hand_->saved);
    if (in_hand_->waited)
        pending.pop_front();
    if (is_step && pending.empty())
        state.message = {"Saved all steps in " + in_hand_->file.parent_path().string(), false};
    in_hand_.reset();
}

bool Photographer::go_on(AppState &state, int width, int height) {
    auto &pending = state.pictures.pending;
    if (in_hand_ && !state.pictures.drawn) { // given up
        in_hand_.reset();
        return true;
    }
    const bool waits = !pending.empty() && !in_hand_;
    const Readiness now = waits ? readiness(state, pending.front()) : Readiness::ready;
    if (now == Readiness::waiting || (!waits && !in_hand_))
        return false;
    if (now == Readiness::hopeless) {
        drop_pictures(state);
        return true;
    }
    try {
        if (waits) {
            const PendingPicture &picture = pending.front();
            const auto file = picture.file.empty() ? numbered_name(pictures_folder(), "penumbra") : picture.file;
            in_hand_.emplace(shot_of(state, picture, file.parent_path(), width, height), file, true);
        }
        draw(state);
    } catch (const std::exception &e) {
        in_hand_.reset();
        state.pictures.drawn.reset();
        pending.clear();
        state.message = {e.what(), true};
    }
    return true;
}

} // namespace penumbra
