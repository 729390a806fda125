#include "truth_verbs.h"

#include "iteration/error_map.h"
#include "picture_verbs.h"
#include "profile_verbs.h"
#include "render/error_scale.h"

#include <algorithm>

namespace penumbra {

namespace {

void apply(AppState &state, const TruthDoing &doing) {
    state.truth.busy = true;
    state.truth.doing = doing.sentence;
}

void apply(AppState &state, const TruthFound &found) {
    if (found.scene == state.scene)
        state.truth.error = found.error;
}

void apply(AppState &state, const ErrorsMapped &mapped) {
    if (mapped.scene == state.scene)
        state.truth.maps[mapped.map->version] = mapped.map;
}

void apply(AppState &state, const ProfileFollowed &followed) {
    if (followed.id == state.profile.asked) {
        state.profile.exact = followed.points;
        state.profile.stale = true;
    }
}

void apply(AppState &state, const TruthFailed &failed) {
    state.truth.halted = true;
    state.message = {failed.sentence, true};
}

void apply(AppState &state, const TruthRested &) {
    state.truth.busy = false;
    state.truth.doing.clear();
}

} // namespace

void apply(AppState &state, const TruthReport &report) {
    std::visit([&](const auto &r) { apply(state, r); }, report);
}

TruthGoal truth_goal(const AppState &state) {
    TruthGoal goal;
    const bool errors = state.look.shading == Shading::error;
    if (!state.scene || state.truth.halted || !(errors || state.profile.open))
        return goal;
    goal.scene = state.scene;
    goal.run = state.run;
    if (errors)
        goal.change = state.look.change;
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        if (const auto snapshot = state.shown_snapshot(pane);
            snapshot && errors && !state.awaits_reconstruction(pane) && !errors_of(state, pane))
            goal.solutions.push_back(snapshot);
    for (auto &snapshot : to_be_judged(state))
        if (std::ranges::find(goal.solutions, snapshot) == goal.solutions.end())
            goal.solutions.push_back(std::move(snapshot));
    goal.profile = profile_question(state);
    return goal;
}

std::shared_ptr<const ErrorMap> errors_of(const AppState &state, int pane) {
    const auto snapshot = state.shown_snapshot(pane);
    return snapshot ? pictured_errors(state, *snapshot) : nullptr;
}

void update_error_range(AppState &state) {
    if (state.look.shading != Shading::error || (state.truth.range_locked && state.look.error_range))
        return;
    std::vector<Judged> judged;
    std::vector<std::uint64_t> versions{static_cast<std::uint64_t>(state.look.error)};
    std::vector<std::shared_ptr<const void>> kept;
    for (int pane = 0; pane < n_panes(state.layout); ++pane) {
        const auto map = errors_of(state, pane);
        const auto snapshot = state.shown_snapshot(pane);
        if (!map)
            return;
        judged.push_back({snapshot.get(), map.get()});
        versions.push_back(map->version);
        versions.push_back(map->change ? 1 + static_cast<std::uint64_t>(map->change->effect) : 0);
        kept.insert(kept.end(), {snapshot, map});
    }
    if (state.look.error_range && versions == state.truth.ranged)
        return;
    state.look.error_range = error_range(state.look.error, judged);
    state.truth.ranged = std::move(versions);
}

void show_errors(AppState &state, ErrorKind kind) {
    if (state.look.error != kind) {
        state.look.error_range.reset();
        state.truth.range_locked = false;
    }
    state.look.error = kind;
    state.look.shading = Shading::error;
    state.truth.halted = false;
    state.message = {std::string(error_sentence(kind)), false};
}

void toggle_range_lock(AppState &state) {
    state.truth.range_locked = !state.truth.range_locked && state.look.error_range;
    state.message = {state.truth.range_locked ? "The error's scale stays as it is, through steps and strategies."
                                              : "The error's scale follows what is shown.",
                     false};
}

void stop_judging(AppState &state) {
    state.truth.halted = true;
    state.truth.busy = false;
    state.truth.doing.clear();
    state.message = {"Stopped measuring; what is known stays.", false};
}

} // namespace penumbra
