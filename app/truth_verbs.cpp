#include "truth_verbs.h"

#include "iteration/error_map.h"
#include "pane_verbs.h"
#include "picture_verbs.h"
#include "profile_verbs.h"
#include "render/error_scale.h"

#include <algorithm>

namespace penumbra {

namespace {

/// Those whose errors are shown; of a difference the second alone.
std::vector<int> judged_panes(const AppState &state) {
    if (state.layout == Layout::difference)
        return {1};
    std::vector<int> all;
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        all.push_back(pane);
    return all;
}

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
        state.truth.maps[{mapped.map->version, mapped.map->against}] = mapped.map;
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
    const Look look = state.shown_look();
    const bool errors = look.shading == Shading::error;
    std::vector<Judging> for_pictures = to_be_judged(state);
    if (!state.scene || state.truth.halted || !(errors || state.profile.open || !for_pictures.empty()))
        return goal;
    goal.scene = state.scene;
    goal.run = state.run;
    if (errors || !for_pictures.empty())
        goal.change = state.look.change;
    const auto is_there = [&](int pane) { return state.shown_snapshot(pane) && !state.awaits_reconstruction(pane); };
    const auto minus = subtracted(state);
    for (const int pane : judged_panes(state))
        if (errors && is_there(pane) && !errors_of(state, pane) && (!look.difference || (minus && is_there(0))))
            goal.solutions.push_back({state.shown_snapshot(pane), minus});
    for (Judging &judging : for_pictures)
        if (std::ranges::find(goal.solutions, judging) == goal.solutions.end())
            goal.solutions.push_back(std::move(judging));
    goal.profile = profile_question(state);
    return goal;
}

std::shared_ptr<const ErrorMap> errors_of(const AppState &state, int pane) {
    const auto snapshot = state.shown_snapshot(pane);
    const auto minus = subtracted(state);
    if (!snapshot || (state.layout == Layout::difference && !minus))
        return nullptr;
    return pictured_errors(state, {snapshot, minus});
}

std::shared_ptr<const Snapshot> subtracted(const AppState &state) {
    return state.layout == Layout::difference ? state.shown_snapshot(0) : nullptr;
}

std::optional<Rgb> difference_under_cursor(const AppState &state) {
    const auto minus = subtracted(state);
    if (!minus || !state.under_cursor || state.under_cursor->patch < 0)
        return std::nullopt;
    const Pick &pick = *state.under_cursor;
    const Vec2 p = to_plane(minus->surfaces[static_cast<std::size_t>(pick.surface)], pick.point);
    const int patch = patch_at(*minus, pick.surface, p);
    if (patch < 0)
        return std::nullopt;
    return Rgb(pick.radiosity - radiosity(*minus, minus->patches[static_cast<std::size_t>(patch)], p));
}

namespace {

/// One range for the errors of these panes.
void update_error_range(AppState &state, const std::vector<int> &panes, std::vector<std::uint64_t> &ranged) {
    Tone tone = state.tone_of(panes.front());
    if (tone.error_range_locked && tone.error_range)
        return;
    const ErrorKind kind = state.shown_look().error;
    std::vector<Judged> judged;
    std::vector<std::uint64_t> versions{static_cast<std::uint64_t>(kind)};
    std::vector<std::shared_ptr<const void>> kept;
    for (const int pane : panes) {
        const auto map = errors_of(state, pane);
        const auto snapshot = state.shown_snapshot(pane);
        if (!map)
            return;
        judged.push_back({snapshot.get(), map.get()});
        versions.push_back(map->version);
        versions.push_back(map->against);
        versions.push_back(map->change ? 1 + static_cast<std::uint64_t>(map->change->effect) : 0);
        kept.insert(kept.end(), {snapshot, map});
    }
    if (tone.error_range && versions == ranged)
        return;
    tone.error_range = error_range(kind, judged);
    set_tone(state, panes.front(), tone);
    ranged = std::move(versions);
}

} // namespace

void update_error_ranges(AppState &state) {
    if (state.shown_look().shading != Shading::error)
        return;
    if (!state.has_own_tones())
        update_error_range(state, judged_panes(state), state.truth.ranged.front());
    else
        for (const int pane : judged_panes(state))
            update_error_range(state, {pane}, state.truth.ranged[static_cast<std::size_t>(pane)]);
}

void show_errors(AppState &state, ErrorKind kind) {
    if (state.look.error != kind)
        forget_error_ranges(state);
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
