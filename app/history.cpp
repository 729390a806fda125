#include "history.h"

#include "keyhole_verbs.h"
#include "move_verbs.h"
#include "pane_verbs.h"
#include "profile_verbs.h"
#include "verbs.h"

#include <utility>
#include <vector>

namespace penumbra {

namespace {

constexpr std::size_t most_changes = 200;
constexpr double one_movement = 1; ///< [s]

bool differ_by_camera_alone(const Parameters &a, Parameters b) {
    b.camera = a.camera;
    if (a.pane_cameras && b.pane_cameras)
        b.pane_cameras = a.pane_cameras;
    return a == b;
}

/// Which pane is active is no change that is taken back; with it goes which pane's own the look has.
Parameters but_the_active_pane(Parameters p) {
    for (PaneSet &panes : p.pane_sets)
        panes.active = 0;
    if (p.pane_tones)
        p.look = with_tone(p.look, {});
    return p;
}

/// Of all panes, without the ranges that follow what is shown.
std::array<Tone, 4> chosen_tones(const AppState &state) {
    std::array<Tone, 4> tones = state.pane_tones;
    if (state.has_own_tones())
        tones[static_cast<std::size_t>(state.panes().active)] = state.tone_of(state.panes().active);
    for (Tone &tone : tones) {
        if (!tone.range_chosen)
            tone.range.reset();
        if (!tone.error_range_locked)
            tone.error_range.reset();
    }
    return tones;
}

void put_back(AppState &state, const Parameters &p) {
    if (p.scene != state.scene)
        set_moves(state, p.scene, p.moves);
    if (p.options != state.options)
        start_again(state, p.options);
    put_away_own(state);
    state.layout = p.layout;
    state.pane_sets = p.pane_sets;
    state.wipe = p.wipe;
    if (p.steps_unlinked && !state.steps_unlinked)
        state.pane_positions.fill(state.position);
    state.steps_unlinked = p.steps_unlinked;
    state.tones_unlinked = false; // this step's own follow
    take_up_own(state);
    const Look shown = std::exchange(state.look, p.look);
    state.chosen_range = p.look.range;
    if (!p.look.range)
        state.look.range = shown.range; // follows what is shown
    state.truth.range_locked = p.look.error_range.has_value();
    state.truth.ranged = {};
    state.tones_unlinked = p.pane_tones.has_value();
    state.pane_tones = p.pane_tones.value_or(state.pane_tones);
    state.camera_is_set = state.camera_moved = p.camera.has_value();
    if (p.camera)
        state.camera = *p.camera;
    state.cameras_unlinked = p.pane_cameras.has_value();
    state.pane_cameras = p.pane_cameras.value_or(state.pane_cameras);
    state.keyhole.open = p.keyhole.has_value();
    if (p.keyhole)
        move_keyhole(state, p.keyhole->surface, p.keyhole->point);
    state.profile.open = p.profile.has_value();
    if (p.profile)
        set_profile(state, p.profile->first.surface, p.profile->first.point, p.profile->second);
    state.pinned_curve = p.pinned_curve;
    state.legend_hidden = p.legend_hidden;
}

void travel(AppState &state, std::vector<Parameters> &from, std::vector<Parameters> &to, const char *verb) {
    History &history = state.history;
    const Parameters here = *history.present, there = from.back();
    to.push_back(here);
    from.pop_back();
    put_back(state, there);
    history.present = parameters(state);
    state.message = {std::string(verb) + change_words(here, there) + ".", false};
}

} // namespace

Parameters parameters(const AppState &state) {
    Parameters p;
    p.scene = state.scene;
    p.moves = state.objects.moves;
    p.options = state.options;
    p.layout = state.layout;
    p.pane_sets = state.pane_sets;
    p.wipe = state.wipe;
    p.look = state.look;
    p.look.range = state.chosen_range;
    p.look.spotlight = {};
    if (!state.truth.range_locked)
        p.look.error_range.reset();
    if (state.camera_moved)
        p.camera = state.camera;
    if (state.cameras_unlinked)
        p.pane_cameras = state.pane_cameras;
    if (state.tones_unlinked)
        p.pane_tones = chosen_tones(state);
    p.steps_unlinked = state.steps_unlinked;
    if (state.keyhole.open && state.keyhole.seen)
        p.keyhole = SurfacePoint{state.keyhole.seen->surface.index, state.keyhole.seen->point};
    if (state.profile.open && state.profile.line)
        p.profile = std::pair(SurfacePoint{state.profile.line->surface, state.profile.line->from}, state.profile.line->to);
    p.pinned_curve = state.pinned_curve;
    p.legend_hidden = state.legend_hidden;
    return p;
}

void note_changes(AppState &state, Clock::time_point now) {
    History &history = state.history;
    Parameters p = parameters(state);
    if (!history.present) {
        history.present = std::move(p);
        return;
    }
    if (p == *history.present)
        return;
    if (but_the_active_pane(p) == but_the_active_pane(*history.present)) {
        history.present = std::move(p);
        return;
    }
    const bool moved = differ_by_camera_alone(*history.present, p);
    const bool still_moving = moved && std::chrono::duration<double>(now - history.moved_at).count() < one_movement;
    if (!still_moving || history.past.empty())
        history.past.push_back(*history.present);
    if (history.past.size() > most_changes)
        history.past.erase(history.past.begin());
    history.moved_at = moved ? now : Clock::time_point();
    history.future.clear();
    history.present = std::move(p);
}

void forget_changes(AppState &state) { state.history = {}; }

bool can_undo(const AppState &state) { return !state.history.past.empty(); }
bool can_redo(const AppState &state) { return !state.history.future.empty(); }
void undo(AppState &state) { travel(state, state.history.past, state.history.future, "Undone: "); }
void redo(AppState &state) { travel(state, state.history.future, state.history.past, "Done again: "); }

std::string change_words(const Parameters &a, const Parameters &b) {
    std::vector<std::string> what;
    const auto say = [&](bool differs, const char *words) {
        if (differs)
            what.emplace_back(words);
    };
    say(a.scene != b.scene, "where things are");
    say(a.options != b.options, "the options");
    say(a.layout != b.layout || a.pane_sets != b.pane_sets || a.wipe != b.wipe || a.steps_unlinked != b.steps_unlinked, "the panes");
    say(a.look != b.look || a.pane_tones != b.pane_tones || a.legend_hidden != b.legend_hidden, "what is shown");
    say(a.camera != b.camera || a.pane_cameras != b.pane_cameras, "the view");
    say(a.keyhole != b.keyhole, "the keyhole");
    say(a.profile != b.profile, "the profile");
    say(a.pinned_curve != b.pinned_curve, "the curve that is pinned");
    std::string out;
    for (std::size_t i = 0; i < what.size(); ++i)
        out += (i == 0 ? "" : i + 1 == what.size() ? " and " : ", ") + what[i];
    return out;
}

} // namespace penumbra
