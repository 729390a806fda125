#include "verbs.h"

#include "core/sentence.h"
#include "element_verbs.h"
#include "files/settings.h"
#include "history.h"
#include "keyhole_verbs.h"
#include "move_verbs.h"
#include "picture_verbs.h"
#include "restore.h"
#include "split_verbs.h"

#include <algorithm>
#include <cstdio>
#include <type_traits>
#include <utility>

namespace penumbra {

namespace {

/// The last position at which any solution that steps still changes, when all of them have ended.
int end_position(const AppState &state) {
    int end = 0;
    for (const Strategy s : state.stepping())
        end = std::max(end, state.timeline(s).last());
    return end;
}

bool all_ended(const AppState &state) {
    return std::ranges::all_of(state.stepping(), [&](Strategy s) { return state.timeline(s).ended; });
}

bool all_reached(const AppState &state) {
    return std::ranges::all_of(state.stepping(), [&](Strategy s) { return state.timeline(s).reached(state.position); });
}

std::string end_sentence(const AppState &state) {
    const auto snapshot = state.timeline(state.active_strategy()).at(end_position(state));
    if (snapshot && (snapshot->counters.exhausted || (snapshot->options.tolerance && snapshot->counters.converged)))
        return as_sentence(snapshot->sentence); // which tells the error
    if (snapshot && snapshot->counters.converged)
        return "Converged: another step would change nothing.";
    return "At the last iteration that is allowed.";
}

/// What just happened in the active pane.
void tell(AppState &state) {
    if (const auto k = shown_splits(state))
        show_splits(state, *k);
    else if (const auto linking = shown_linkings(state))
        show_linkings(state, *linking);
    else if (const auto snapshot = state.active_solution())
        state.message = {snapshot->sentence, false};
}

/// Panes at other steps than the active one, which were sent farther than their solution goes.
void come_to_its_end(AppState &state, Strategy strategy) {
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        if (int &position = state.pane_positions[static_cast<std::size_t>(pane)];
            state.steps_unlinked && pane != state.panes().active && state.strategy_of(pane) == strategy)
            position = std::min(position, state.timeline(strategy).last());
}

void start_anew(AppState &state) {
    ++state.run;
    for (const Timeline &timeline : state.timelines)
        state.prices.keep(timeline);
    state.prices.predicted = {};
    state.timelines = {};
    state.busy.reset();
    state.under_cursor.reset();
    state.chosen_range.reset();
    state.halted = false;
    state.truth.maps.clear();
    state.reconstructions.clear();
    state.truth.halted = false;
    state.split.reset();
    state.linking.reset();
    state.seeking = false;
    state.stepped_from = state.position;
    state.split_snapshots.clear();
}

void apply(AppState &state, const Opened &opened) {
    const Scene &scene = *opened.file.scene;
    const bool same = state.scene && state.scene->name == scene.name;
    set_scene(state, opened.file.original ? opened.file.original : opened.file.scene);
    if (opened.file.original)
        set_moves(state, opened.file.scene, opened.file.moves);
    state.look.curve_filter.source = -1;
    state.opening.clear();
    state.playing = false;
    state.position = 0;
    state.prices = {};
    if (!same)
        state.camera_is_set = state.cameras_unlinked = false;
    state.steps_unlinked = state.tones_unlinked = false;
    forget_changes(state);
    const std::vector<std::string> notes = opened.file.notes();
    state.message = {"Opened " + scene.name + ": " + std::to_string(scene.n_surfaces()) + " surfaces." +
                         (notes.empty() ? "" : " " + notes.front()),
                     false};
    if (opened.file.state)
        restore(state, *opened.file.state);
    if (const auto view = std::exchange(state.to_restore, std::nullopt))
        bring_back(state, *view);
}

void apply(AppState &state, const Refused &refused) {
    state.opening.clear();
    state.to_restore.reset();
    state.message = {refused.sentence, true};
}

void apply(AppState &state, const Begun &begun) {
    if (begun.run == state.run)
        state.busy = Busy{begun.strategy, begun.position, Clock::now()};
}

void apply(AppState &state, const Reached &reached) {
    if (reached.run != state.run)
        return;
    Timeline &timeline = state.timeline(reached.strategy);
    timeline.moments.resize(static_cast<std::size_t>(reached.position));
    timeline.moments.push_back(reached.snapshot);
    timeline.ended = reached.ended;
    state.busy.reset();
    state.fresh_since = Clock::now();
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        if (state.strategy_of(pane) == reached.strategy && timeline.reached(state.asked_position(pane)))
            state.objects.shown_before[static_cast<std::size_t>(pane)].reset();
    if (timeline.ended)
        come_to_its_end(state, reached.strategy);
    find_what_was_restored(state, reached.strategy);
    if (state.position > 0 && reached.strategy == state.active_strategy())
        tell(state);
    if (state.position > end_position(state) && all_ended(state)) {
        state.position = end_position(state);
        state.playing = false;
        state.message = {end_sentence(state), false};
    }
    go_on_seeking(state);
}

void apply(AppState &state, const Reconstructed &made) {
    if (made.run == state.run)
        state.reconstructions[made.version] = made.snapshot;
}

void apply(AppState &state, const Inspected &made) {
    if (made.run != state.run)
        return;
    ElementMode &mode = state.element;
    mode.shown = made.report;
    mode.version = made.version;
    mode.strategy = made.asked.stand.strategy;
    mode.answered = made.asked.question;
}

void apply(AppState &state, const Failed &failed) {
    if (failed.run != state.run)
        return;
    state.timeline(failed.strategy).ended = true;
    state.busy.reset();
    state.playing = false;
    state.message = {failed.sentence, true};
}

void apply(AppState &state, const Stopped &) {
    state.busy.reset();
    state.opening.clear();
    // Linked panes go back to the last step that all of them have.
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        if (const Timeline &course = state.timeline(state.strategy_of(pane)); !course.ended) {
            const bool own = state.has_own_steps() && pane != state.panes().active;
            int &position = own ? state.pane_positions[static_cast<std::size_t>(pane)] : state.position;
            position = std::clamp(position, 0, std::max(0, course.last()));
        }
    state.message = {"Cancelled; this is the last complete state.", false};
}

void apply(AppState &state, const Rested &) { state.busy.reset(); }

} // namespace

std::optional<Goal> goal(const AppState &state) {
    if (auto for_a_picture = picture_goal(state))
        return for_a_picture;
    if (!state.scene || state.halted)
        return std::nullopt;
    Goal goal{state.run, state.scene, state.options};
    for (int pane = 0; pane < n_panes(state.layout); ++pane) {
        const Stand stand{state.strategy_of(pane), state.asked_position(pane)};
        goal.stands.push_back(stand);
        if (state.reconstructs(pane))
            goal.reconstructed.push_back(stand);
    }
    goal.inspected = inspection(state);
    return goal;
}

bool at_end(const AppState &state) { return all_ended(state) && state.position >= end_position(state); }

void go_to(AppState &state, int position) {
    state.halted = false;
    state.seeking = false;
    state.hint_done = state.hint_done || position > 0;
    if (position > state.position && at_end(state)) {
        state.playing = false;
        state.message = {end_sentence(state), false};
        return;
    }
    position = std::max(0, position);
    if (position != state.position)
        state.stepped_from = state.position;
    state.split.reset();
    state.linking.reset();
    state.position = all_ended(state) ? std::min(position, end_position(state)) : position;
    state.fresh_since = Clock::now();
    if (all_reached(state))
        tell(state);
}

double advance_play(AppState &state, Clock::time_point now) {
    if (!state.playing)
        return -1;
    if (at_end(state)) {
        state.playing = false;
        state.message = {end_sentence(state), false};
        return -1;
    }
    if (!all_reached(state))
        return -1; // the worker's report wakes us
    if (const auto wait = advance_splits(state, now))
        return *wait;
    if (state.play_until && state.position >= *state.play_until) {
        state.playing = false;
        state.play_until.reset();
        return -1;
    }
    const double shown_for = std::chrono::duration<double>(now - state.fresh_since).count();
    const double wait = 1 / state.phases_per_second - shown_for;
    if (wait > 0)
        return wait;
    go_to(state, state.position + 1);
    begin_animation(state);
    return all_reached(state) ? 1 / state.phases_per_second : -1;
}

void set_scene(AppState &state, std::shared_ptr<const Scene> scene) {
    state.scene = std::move(scene);
    state.hovered_curve.reset();
    state.pinned_curve.reset();
    state.keyhole = {};
    state.microscope = {};
    state.element = {};
    state.keyhole_to_open.reset();
    const int lines = state.profile.asked; // their numbers are not used twice
    state.profile = {};
    state.profile.asked = lines;
    state.profile_to_open.reset();
    state.truth = {};
    const auto original = state.scene;
    state.objects = {};
    state.objects.original = original;
    start_anew(state);
}

void replace_scene(AppState &state, std::shared_ptr<const Scene> scene) {
    const bool at_the_end = at_end(state);
    state.scene = std::move(scene);
    state.hovered_curve.reset();
    state.pinned_curve.reset();
    state.truth = {};
    state.profile.exact.clear();
    state.profile.asked += 1;
    state.profile.stale = true;
    state.prices = {};
    start_anew(state);
    if (at_the_end)
        state.position = far_ahead;
    if (state.keyhole.open && state.keyhole.seen)
        state.keyhole_to_open = state.keyhole.seen->point;
}

void set_speed(AppState &state, double steps_per_second) {
    state.phases_per_second = std::clamp(steps_per_second, slowest_play, fastest_play);
    char text[64];
    std::snprintf(text, sizeof text, "Playing shows %.3g steps a second.", state.phases_per_second);
    state.message = {text, false};
}

void set_options(AppState &state, const Options &options) {
    state.options = options;
    start_anew(state);
    state.message = {"Starting anew with these options.", false};
}

void start_again(AppState &state, const Options &options) {
    const bool at_the_end = at_end(state);
    set_options(state, options);
    if (at_the_end)
        go_to(state, far_ahead);
}

void set_strategy(AppState &state, Strategy strategy) {
    const auto active = static_cast<std::size_t>(state.panes().active);
    state.panes().strategies[active] = strategy;
    state.panes().reconstructed[active] = false;
    state.halted = false;
    state.message = {std::string(title(strategy)) + ".", false};
}

void toggle_reconstruction(AppState &state) {
    bool &on = state.panes().reconstructed[static_cast<std::size_t>(state.panes().active)];
    on = !on;
    state.halted = false;
    state.message = {on ? "Quadratics, made for the eye from the solution of constants: as pictures were in 1993."
                        : "The constants themselves.",
                     false};
}

void reset_view(AppState &state) {
    const auto snapshot = state.active_solution();
    if (!state.has_own_cameras())
        state.camera_is_set = false;
    else if (snapshot && state.scene)
        state.camera_of(state.panes().active) = first_view(*state.scene, *snapshot, state.pane_aspect);
}

void fit_view(AppState &state) {
    if (const auto snapshot = state.active_solution()) {
        Camera &camera = state.camera_of(state.panes().active);
        camera = fit(camera, *snapshot, state.pane_aspect);
        state.camera_moved = true;
        state.pivot.reset();
    }
}

Spotlight spotlight(const AppState &state) {
    if (crossing_glows(state, Clock::now()) > 0)
        return {state.keyhole.crossed, false};
    return {state.pinned_curve.value_or(state.hovered_curve.value_or(-1))};
}

void apply(AppState &state, const Report &report) {
    std::visit([&](const auto &r) { apply(state, r); }, report);
}

} // namespace penumbra
