#include "pane_verbs.h"

#include "verbs.h"

#include <string>
#include <vector>

namespace penumbra {

namespace {

/// Of the steps of these panes' strategies.
std::optional<Range> range_over(const AppState &state, const std::vector<int> &panes) {
    std::vector<const Snapshot *> snapshots;
    for (const int pane : panes)
        for (const auto &moment : state.timeline(state.strategy_of(pane)).moments)
            if (moment && moment->peak > 0)
                snapshots.push_back(moment.get());
    if (snapshots.empty()) // nothing is lit yet
        for (const int pane : panes)
            if (const auto &moments = state.timeline(state.strategy_of(pane)).moments; !moments.empty())
                snapshots.push_back(moments.front().get());
    return snapshots.empty() ? std::nullopt : std::optional(common_range(snapshots));
}

} // namespace

void put_away_own(AppState &state) {
    const auto active = static_cast<std::size_t>(state.panes().active);
    if (state.has_own_tones())
        state.pane_tones[active] = state.tone_of(state.panes().active);
    if (state.has_own_steps())
        state.pane_positions[active] = state.position;
}

void take_up_own(AppState &state) {
    const auto active = static_cast<std::size_t>(state.panes().active);
    if (state.has_own_tones())
        set_tone(state, state.panes().active, state.pane_tones[active]);
    if (!state.has_own_steps() || state.pane_positions[active] == state.position)
        return;
    state.position = state.stepped_from = state.pane_positions[active];
    state.split.reset();
    state.linking.reset();
    state.playing = state.seeking = false;
}

void activate(AppState &state, int pane) {
    if (pane == state.panes().active)
        return;
    put_away_own(state);
    state.panes().active = pane;
    take_up_own(state);
}

void set_layout(AppState &state, Layout layout) {
    const ErrorKind ranged = state.shown_look().error;
    const bool had_own_tones = state.has_own_tones(), had_own_steps = state.has_own_steps();
    put_away_own(state);
    state.layout = layout;
    if (layout == Layout::difference)
        state.panes().active = 1;
    const auto active = static_cast<std::size_t>(state.panes().active);
    if (!had_own_tones)
        state.pane_tones[active] = state.tone_of(state.panes().active);
    if (!had_own_steps)
        state.pane_positions[active] = state.position;
    take_up_own(state);
    state.truth.ranged = {};
    if (state.shown_look().error != ranged)
        forget_error_ranges(state);
    if (layout == Layout::difference)
        state.truth.halted = false;
    state.halted = false;
    state.message = {};
}

void flip(AppState &state) {
    if (state.layout == Layout::flip)
        activate(state, 1 - state.panes().active);
    set_layout(state, Layout::flip);
    state.message = {std::string("(") + letter(state.active_strategy()) + ") " +
                         std::string(title(state.active_strategy())) + "; Shift+W shows the other.",
                     false};
}

void toggle_cameras(AppState &state) {
    if (!state.cameras_unlinked)
        state.pane_cameras.fill(state.camera);
    else
        state.camera = state.active_camera();
    state.camera_moved = true;
    state.cameras_unlinked = !state.cameras_unlinked;
    state.message = {state.cameras_unlinked ? "Each pane has a view of its own." : "All panes have the active pane's view.", false};
}

void toggle_tones(AppState &state) {
    state.pane_tones.fill(state.tone_of(state.panes().active));
    state.tones_unlinked = !state.tones_unlinked;
    state.truth.ranged = {};
    state.message = {state.tones_unlinked ? "Each pane has its own exposure and range of colours; keys and sliders set the active pane's."
                                          : "All panes have the active pane's exposure, and one range of colours.",
                     false};
}

void toggle_steps(AppState &state) {
    state.pane_positions.fill(state.position);
    state.steps_unlinked = !state.steps_unlinked;
    state.halted = false;
    state.message = {state.steps_unlinked ? "Each pane stands at a step of its own; stepping moves the active pane alone."
                                          : "All panes stand at the active pane's step.",
                     false};
}

void set_tone(AppState &state, int pane, const Tone &tone) {
    if (state.has_own_tones() && pane != state.panes().active) {
        state.pane_tones[static_cast<std::size_t>(pane)] = tone;
        return;
    }
    state.look = with_tone(state.look, tone);
    state.chosen_range = tone.range_chosen ? tone.range : std::nullopt;
    state.truth.range_locked = tone.error_range_locked;
}

void forget_error_ranges(AppState &state) {
    state.look.error_range.reset();
    state.truth.range_locked = false;
    for (Tone &tone : state.pane_tones) {
        tone.error_range.reset();
        tone.error_range_locked = false;
    }
}

void update_ranges(AppState &state) {
    std::vector<std::vector<int>> groups; // of panes that share a range
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        if (groups.empty() || state.has_own_tones())
            groups.push_back({pane});
        else
            groups.back().push_back(pane);
    for (const std::vector<int> &panes : groups) {
        Tone tone = state.tone_of(panes.front());
        if (!tone.range_chosen)
            if (const auto range = range_over(state, panes))
                tone.range = range;
        set_tone(state, panes.front(), tone);
    }
}

} // namespace penumbra
