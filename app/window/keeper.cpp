#include "window/keeper.h"

#include "core/error.h"
#include "files/autosave.h"
#include "files/kept_file.h"
#include "files/own_folders.h"
#include "files/recent_files.h"
#include "files/state_text.h"
#include "files/write_state.h"
#include "tour.h"

#include <algorithm>
#include <filesystem>

namespace penumbra {

namespace {

namespace fs = std::filesystem;

/// While the solver is busy every frame may show something new [s].
double interval(const AppState &state) { return state.busy ? 10 : 2; }

Settings settings_of(const AppState &state) {
    return {state.ui_scale, state.chosen_theme, state.phases_per_second, state.tour_seen};
}

std::string autosave_text(const AppState &state) { return state_text(saved_state(state, state_folder())); }

/// Whether what is shown is all that there is for now.
bool has_begun(const AppState &state) { return state.camera_is_set && !state.busy && state.opening.empty(); }

/// `write` may throw Unavailable, which is said the first time.
template <class Write>
void try_to(AppState &state, bool &fails, const Write &write) {
    if (fails)
        return;
    try {
        write();
    } catch (const Unavailable &e) {
        fails = true;
        state.message = {e.what(), false};
    }
}

} // namespace

void Keeper::begin(AppState &state, bool has_own_theme, bool undisturbed) {
    std::vector<std::string> notes;
    settings_ = read_settings(notes);
    state.ui_scale = settings_.ui_scale;
    state.chosen_theme = settings_.theme;
    if (!has_own_theme)
        state.look.theme = settings_.theme;
    state.phases_per_second = settings_.phases_per_second;
    state.tour_seen = settings_.tour_seen;
    if (!notes.empty())
        state.message = {notes.front(), false};
    state.recent_files = read_recent_files();
    if (undisturbed)
        return;
    for (const fs::path &file : orphaned_autosaves())
        state.orphans.push_back(file.string());
    if (!state.tour_seen)
        toggle_tour(state);
    state.tour_seen = true;
}

void Keeper::note_opened(AppState &state, const std::string &name) {
    const auto orphan = std::ranges::find(state.orphans, name);
    if (orphan == state.orphans.end()) {
        try_to(state, recent_files_fail_, [&] { state.recent_files = note_recent_file(name); });
        return;
    }
    std::error_code failure;
    fs::rename(name, autosave_file(), failure);
    state.orphans.erase(orphan);
    state.message = {"Restored what was shown.", false};
}

void Keeper::discard(AppState &state) {
    if (state.orphans.empty())
        return;
    std::error_code failure;
    fs::remove(state.orphans.front(), failure);
    state.orphans.erase(state.orphans.begin());
    state.message = failure ? Message{"It could not be deleted: " + failure.message(), true} : Message{"Discarded.", false};
}

double Keeper::keep(AppState &state, Clock::time_point now) {
    if (autosaved_.empty() && has_begun(state))
        autosaved_ = autosave_text(state);
    if (looked_)
        return -1;
    const double left = interval(state) - std::chrono::duration<double>(now - last_).count();
    if (left > 0)
        return left;
    last_ = now;
    looked_ = true;
    keep_settings(state);
    keep_autosave(state);
    return -1;
}

void Keeper::keep_settings(AppState &state) {
    const Settings now = settings_of(state);
    if (now == settings_)
        return;
    try_to(state, settings_fail_, [&] { write_settings(now); });
    settings_ = now;
}

void Keeper::keep_autosave(AppState &state) {
    if (autosaved_.empty() || !state.scene)
        return;
    std::string text = autosave_text(state);
    if (text == autosaved_)
        return;
    try_to(state, autosave_fails_, [&] { write_kept_file(autosave_file(), text); });
    autosaved_ = std::move(text);
}

void Keeper::end(AppState &state) {
    keep_settings(state);
    std::error_code none;
    fs::remove(autosave_file(), none);
}

void Keeper::leave_autosave(const AppState &state) noexcept {
    try {
        if (state.scene)
            write_kept_file(autosave_file(), autosave_text(state));
    } catch (const std::exception &) { // the rescue beside it says why nothing can be kept
    }
}

} // namespace penumbra
