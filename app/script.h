// A lecture written down: what is done in the window, line by line. Each line waits until the one before has come to rest.
#pragma once

#include "app_state.h"

#include <functional>
#include <string>
#include <vector>

namespace penumbra {

/// One line of a script.
struct Cue {
    int line = 0;     ///< of the file, from 1
    std::string text; ///< as it stands there
    /// Throws BadInput, without the file's name and line, when it cannot be done now. Called again where it asks for that: it
    /// returns whether it is done.
    std::function<bool(AppState &)> act;
};

struct Script {
    std::string file; ///< for messages
    std::vector<Cue> cues;
};

/// Whether everything that was asked for is there: nothing is solved, read, measured, reconstructed or to be drawn into a
/// file.
bool at_rest(const AppState &state);

/// Where a script stands.
class ScriptPlayer {
public:
    explicit ScriptPlayer(Script script) : script_(std::move(script)) {}

    /// Does the next line where the state is at rest; to be called once a frame. Esc has ended it where state.script.playing is
    /// off. Throws BadInput with file and line.
    void play(AppState &state);

private:
    Script script_;
    std::size_t next_ = 0;
    bool begun_ = false;
};

} // namespace penumbra
