#include "script.h"

#include "core/error.h"
#include "truth_verbs.h"

#include <algorithm>
#include <utility>

namespace penumbra {

bool at_rest(const AppState &state) {
    if (state.busy || state.playing || !state.opening.empty() || state.open_request || state.picture_request || state.pictures.drawn ||
        state.state_request || state.shelf.checking || state.truth.busy || state.quit_request)
        return false;
    if (!state.scene)
        return true;
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        if (!state.halted && (!state.timeline(state.strategy_of(pane)).reached(state.asked_position(pane)) ||
                              state.awaits_reconstruction(pane)))
            return false;
    const TruthGoal wanted = truth_goal(state);
    return wanted.solutions.empty() && !wanted.profile;
}

void ScriptPlayer::play(AppState &state) {
    ScriptMode &mode = state.script;
    if (!std::exchange(begun_, true))
        mode = {true, 0, script_.cues.empty() ? 0 : script_.cues.back().line};
    if (!mode.playing || !at_rest(state))
        return;
    if (next_ == script_.cues.size()) {
        mode.playing = false;
        return;
    }
    const Cue &cue = script_.cues[next_];
    mode.line = cue.line;
    try {
        if (cue.act(state))
            ++next_;
    } catch (const BadInput &e) {
        throw BadInput(script_.file + ":" + std::to_string(cue.line) + ": " + e.what());
    }
}

} // namespace penumbra
