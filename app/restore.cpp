#include "restore.h"

#include "core/error.h"
#include "keyhole_verbs.h"
#include "move_verbs.h"
#include "profile_verbs.h"
#include "verbs.h"

#include <algorithm>
#include <utility>

namespace penumbra {

namespace {

/// Pictures may have other numbers of panes than the window: what is missing is filled up, what is left over falls
/// away.
void restore_panes(AppState &state, const SavedState &saved) {
    state.layout = saved.layout.value_or(layout_of(saved.strategies.size()));
    state.wipe = saved.wipe;
    PaneSet &panes = state.panes();
    const std::size_t n = std::min(saved.strategies.size(), panes.strategies.size());
    std::copy_n(saved.strategies.begin(), n, panes.strategies.begin());
    panes.reconstructed.fill(false);
    std::copy_n(saved.reconstructed.begin(), std::min(n, saved.reconstructed.size()), panes.reconstructed.begin());
    panes.active = std::min(saved.active, static_cast<int>(n) - 1);
}

void open_profile(AppState &state, const Snapshot &snapshot) {
    const auto ends = std::exchange(state.profile_to_open, std::nullopt);
    if (!ends)
        return;
    const auto line = line_over(snapshot, ends->first, ends->second, 1e-3 * state.scene->own.size);
    if (!line) {
        state.message = {"The profile stays closed: its line lies on no surface that reflects.", false};
        return;
    }
    state.profile.open = true;
    set_profile(state, line->surface, line->from, line->to);
}

} // namespace

void restore(AppState &state, const SavedState &saved) {
    const int threads = state.options.threads;
    state.options = saved.options;
    state.options.threads = threads;
    state.asked_tolerance = saved.options.tolerance.value_or(state.asked_tolerance);
    restore_panes(state, saved);
    state.position = saved.position;
    state.split = saved.split;
    state.linking = saved.linking;
    state.hint_done = state.hint_done || saved.position > 0;
    if (saved.camera)
        state.camera = *saved.camera;
    state.camera_is_set = state.camera_moved = saved.camera.has_value();
    state.cameras_unlinked = !saved.cameras.empty();
    std::copy_n(saved.cameras.begin(), std::min(saved.cameras.size(), state.pane_cameras.size()), state.pane_cameras.begin());
    state.tones_unlinked = !saved.tones.empty();
    std::copy_n(saved.tones.begin(), std::min(saved.tones.size(), state.pane_tones.size()), state.pane_tones.begin());
    state.steps_unlinked = !saved.positions.empty();
    std::copy_n(saved.positions.begin(), std::min(saved.positions.size(), state.pane_positions.size()), state.pane_positions.begin());
    state.pivot.reset();
    state.look = saved.look;
    state.look.spotlight = {};
    if (saved.picture) {
        PictureSettings &settings = state.pictures.settings;
        settings.supersample = saved.picture->supersample;
        settings.labels = saved.picture->labels;
        settings.transparent = saved.look.transparent;
    }
    state.look.transparent = false;
    state.chosen_range = saved.range_chosen ? saved.look.range : std::nullopt;
    state.legend_hidden = !saved.legend;
    if (saved.look.spotlight.curve >= 0)
        state.pinned_curve = saved.look.spotlight.curve;
    state.truth.range_locked = saved.error_range_locked && saved.look.error_range;
    state.truth.ranged = {};
    state.caption = saved.caption;
    if (!saved.bookmarks.empty()) {
        state.bookmarks = saved.bookmarks;
        state.bookmark = -1;
    }
    state.keyhole_to_open = saved.keyhole;
    state.profile_to_open = saved.profile;
}

void bring_back(AppState &state, const SavedState &saved) {
    if (saved.moves != state.objects.moves && state.objects.original)
        try {
            set_moves(state, saved.moves);
        } catch (const BadInput &e) {
            state.message = {e.what(), true};
            return;
        }
    Options options = saved.options;
    options.threads = state.options.threads;
    options.strategy = state.options.strategy;
    if (options != state.options)
        set_options(state, options);
    state.keyhole.open = state.profile.open = false;
    state.pinned_curve.reset();
    restore(state, saved);
    state.options.strategy = options.strategy;
    find_what_was_restored(state, state.active_strategy());
    if (state.active_solution())
        state.message = {state.caption, false};
}

void find_what_was_restored(AppState &state, Strategy strategy) {
    const auto snapshot = state.active_solution();
    if (!snapshot || strategy != state.active_strategy())
        return;
    // Curves of reflectors come with later steps.
    const bool there = state.timeline(strategy).reached(state.position);
    if (state.pinned_curve && there && *state.pinned_curve >= static_cast<int>(snapshot->curves->size()))
        state.pinned_curve.reset();
    open_profile(state, *snapshot);
    if (!state.keyhole_to_open)
        return;
    const Vec3 point = *std::exchange(state.keyhole_to_open, std::nullopt);
    const KeyholeEye eye(state.scene);
    const SurfaceId surface = eye.surface_at(point, 1e-3);
    if (!surface.valid()) {
        state.message = {"The keyhole stays closed: its point lies on no surface that reflects.", false};
        return;
    }
    state.keyhole.open = true;
    move_keyhole(state, static_cast<int>(surface.at()), point);
}

} // namespace penumbra
