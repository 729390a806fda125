// What one start of the window leaves to the next: settings, recent files, and an autosave for when it ends unexpectedly.
#pragma once

#include "app_state.h"
#include "files/settings.h"

#include <string>

namespace penumbra {

/// A file that can't be written is said once, in the message, and does not keep the window from anything.
class Keeper {
public:
    /// Takes over settings (the theme only where `state` has none of its own) and recent files. Unless `undisturbed`, opens the
    /// tour at a first start and offers what orphaned autosaves hold.
    void begin(AppState &state, bool has_own_theme, bool undisturbed);

    /// A file or bundled scene of this name was opened. An orphan becomes this window's own autosave.
    void note_opened(AppState &state, const std::string &name);
    /// The first orphan is deleted.
    void discard(AppState &state);

    /// To be told of each frame: something may have changed.
    void note_frame() { looked_ = false; }
    /// Writes what has changed, at most every few seconds. Returns when it should be asked again [s]; negative: not before the
    /// next frame.
    double keep(AppState &state, Clock::time_point now);

    /// A clean end: the settings are written, and no autosave is left.
    void end(AppState &state);
    /// An unexpected one: the next start will offer what is shown now.
    void leave_autosave(const AppState &state) noexcept;

private:
    void keep_settings(AppState &state);
    void keep_autosave(AppState &state);

    Settings settings_;     ///< as they are written
    std::string autosaved_; ///< as it is written, or what the window began with; empty: not begun yet
    bool looked_ = false;   ///< since the last frame
    bool settings_fail_ = false, autosave_fails_ = false, recent_files_fail_ = false;
    Clock::time_point last_;
};

} // namespace penumbra
