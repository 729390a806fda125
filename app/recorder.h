// A session written down as a script that plays it again: `penumbra view --record FILE`.
#pragma once

#include "app_state.h"
#include "scripted.h"

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra {

/// Actions stand in the script by their names where they were done at rest; what else has changed stands there by its effect:
/// what the mouse did, what came from the clipboard or by undoing, and where the solver was stopped. A script waits for the
/// solver; so pauses are counted from when it rested. Whatever changes by itself is left out.
class Recorder {
public:
    /// Begins with the lines that lead from a window that has just opened this scene (or state) to what `now` shows. `fresh`
    /// is that window. The file is whole after each line. Throws Unavailable where it cannot be written; later the state's
    /// message tells that, once, and the record ends.
    Recorder(std::filesystem::path file, const std::string &opened, const AppState &fresh, AppState &now);

    /// What was done since the last call. `held`: the mouse or a field holds something, which is not what it will be.
    void note(AppState &state, Clock::time_point now, bool held);

    /// What a worker's report has changed, by nobody's hand.
    void follow(const Scripted &before, AppState &state);
    /// The worker was stopped on its way to where it was asked to go.
    void note_stopped() { stopped_ = true; }
    /// It has opened what the user asked for; `by_line`: as a line that stands there already does.
    void note_opened(const std::string &name, bool by_line, const Scripted &before, AppState &state);

private:
    void write_deed(const Deed &deed, AppState &state, Clock::time_point now);
    void write_lines(const std::vector<std::string> &lines, AppState &state, Clock::time_point now);
    void forget_asked();
    void keep(AppState &state);

    std::filesystem::path file_;
    std::vector<std::string> lines_;
    std::size_t rested_ = 0;       ///< lines that had been written when the solver rested last
    Scripted known_;               ///< what the lines lead to
    Clock::time_point quiet_since_;
    bool stopped_ = false, ended_ = false;
};

/// As `open` of scripts takes it wherever they are played: a bundled scene's name, or a file with its whole path.
std::string lasting_name(const std::string &name);

} // namespace penumbra
