#include "split_verbs.h"

#include "iteration/after_splits.h"
#include "verbs.h"

#include <algorithm>
#include <map>
#include <utility>

namespace penumbra {

namespace {

constexpr double longest_animation = 1; ///< of one refinement's splits [s]

bool is_there(const AppState &state) { return state.timeline(state.active_strategy()).last() >= state.position; }

const std::vector<SnapshotEvent> &events(const AppState &state) {
    return *state.active_solution()->events;
}

/// The first refinement after the position.
constexpr int next_refinement(int position) {
    return position_of(phase_of(position) == Phase::start ? 1 : iteration_of(position) + 1, Phase::refined);
}

} // namespace

int n_splits(const AppState &state) {
    return is_there(state) ? n_events(*state.active_solution()) : 0;
}

std::optional<int> shown_splits(const AppState &state) {
    const int n = n_splits(state);
    return state.split && n > 0 ? std::optional(std::clamp(*state.split, 1, n)) : std::nullopt;
}

int n_linkings(const AppState &state) {
    return is_there(state) ? n_linkings(*state.active_solution()) : 0;
}

std::optional<int> shown_linkings(const AppState &state) {
    const int n = n_linkings(state);
    return state.linking && !state.split && n > 0 ? std::optional(std::clamp(*state.linking, 1, n)) : std::nullopt;
}

void show_splits(AppState &state, int k) {
    state.seeking = false;
    state.split = k;
    state.linking.reset();
    state.fresh_since = Clock::now();
    if (n_splits(state) > 0)
        state.message = {events(state)[static_cast<std::size_t>(*shown_splits(state) - 1)].sentence, false};
}

void show_linkings(AppState &state, int k) {
    state.seeking = false;
    state.split.reset();
    state.linking = k;
    state.fresh_since = Clock::now();
    if (const auto shown = shown_linkings(state))
        state.message = {(*state.active_solution()->linkings)[static_cast<std::size_t>(*shown - 1)].sentence, false};
}

void next_linking(AppState &state) {
    const int n = n_linkings(state);
    const int k = shown_splits(state) ? 0 : shown_linkings(state).value_or(n);
    if (k < n) {
        show_linkings(state, k + 1);
        return;
    }
    const int there = next_refinement(state.position);
    go_to(state, there);
    if (state.position == there)
        show_linkings(state, 1);
}

void previous_linking(AppState &state) {
    const auto k = shown_linkings(state);
    if (k && *k == 1 && n_splits(state) > 0)
        show_splits(state, n_splits(state));
    else if (k && *k > 1)
        show_linkings(state, *k - 1);
    else if (!k && !shown_splits(state) && n_linkings(state) > 0)
        show_linkings(state, n_linkings(state));
    else
        previous_split(state);
}

void next_split(AppState &state) {
    const int n = n_splits(state), before = state.position;
    if (const int k = shown_splits(state).value_or(n); k < n) {
        show_splits(state, k + 1);
        return;
    }
    go_to(state, before + 1);
    if (state.position > before && phase_of(state.position) == Phase::refined)
        show_splits(state, 1);
}

void previous_split(AppState &state) {
    if (shown_linkings(state) && n_splits(state) > 0) {
        show_splits(state, n_splits(state));
        return;
    }
    if (const int k = shown_splits(state).value_or(n_splits(state)); k > 1) {
        show_splits(state, k - 1);
        return;
    }
    go_to(state, state.position - 1);
    if (phase_of(state.position) == Phase::refined && n_splits(state) > 0)
        show_splits(state, n_splits(state));
}

void seek_cut(AppState &state) {
    state.playing = false;
    if (!state.split && n_splits(state) > 0) // all of them are shown already
        state.split = n_splits(state);
    state.seeking = true;
    go_on_seeking(state);
}

void go_on_seeking(AppState &state) {
    while (state.seeking && state.timeline(state.active_strategy()).reached(state.position)) {
        for (int k = state.split.value_or(0); k < n_splits(state); ++k)
            if (events(state)[static_cast<std::size_t>(k)].curve >= 0) {
                show_splits(state, k + 1);
                return;
            }
        const int before = state.position;
        go_to(state, next_refinement(before));
        state.seeking = state.position == next_refinement(before);
        if (!state.seeking)
            state.message = {"No cut along a curve follows up to the end of this solution.", false};
    }
}

std::optional<double> advance_splits(AppState &state, Clock::time_point now) {
    const int n = n_splits(state);
    const auto k = shown_splits(state);
    if (!k || !state.animates_splits) {
        state.split.reset();
        return std::nullopt;
    }
    const double pace = std::max(state.phases_per_second, n / longest_animation);
    const double due = std::chrono::duration<double>(now - state.fresh_since).count() * pace;
    if (due < 1)
        return (1 - due) / pace;
    const int on = static_cast<int>(std::min(due, static_cast<double>(n)));
    const auto since = state.fresh_since +
                       std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(on / pace));
    if (*k + on <= n) {
        show_splits(state, *k + on);
        state.fresh_since = since;
        return 1 / pace;
    }
    state.split.reset();
    state.fresh_since = now;
    return std::nullopt;
}

void begin_animation(AppState &state) {
    if (state.animates_splits && state.shown_look().shading != Shading::error && phase_of(state.position) == Phase::refined)
        show_splits(state, 1);
}

void bring_splits(AppState &state) {
    std::map<std::uint64_t, std::shared_ptr<const Snapshot>> wanted;
    for (int pane = 0; pane < n_panes(state.layout); ++pane) {
        const Place place = state.shown_place(pane);
        const auto whole = state.timeline(state.strategy_of(pane)).at(place.position);
        const RefinementPart part{place.split, place.linking};
        if (!whole || version_of(*whole, part) == whole->version)
            continue;
        const std::uint64_t version = version_of(*whole, part);
        const auto found = state.split_snapshots.find(version);
        wanted[version] = found == state.split_snapshots.end() ? part_of(*whole, part) : found->second;
    }
    state.split_snapshots = std::move(wanted);
}

Place AppState::shown_place(int pane) const {
    if (has_own_steps() && pane != panes().active)
        return {asked_position(pane)};
    return shows_before() ? place_before(*this) : Place{position, split, linking};
}

Place place_before(const AppState &state) {
    if (const auto k = shown_splits(state); k && *k > 1)
        return {state.position, *k - 1, std::nullopt};
    if (const auto k = shown_linkings(state))
        return {state.position, std::nullopt, *k - 1};
    const int at = state.shown_position();
    if (!shown_splits(state) && state.stepped_from < at)
        return {state.stepped_from};
    return {std::max(0, at - 1)};
}

} // namespace penumbra
