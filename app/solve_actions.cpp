#include "menu_actions.h"

#include "effect_verbs.h"
#include "files/settings.h"
#include "picture_verbs.h"
#include "profile_verbs.h"
#include "shelf_verbs.h"
#include "split_verbs.h"
#include "truth_verbs.h"
#include "verbs.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace penumbra {

namespace {

bool can_go_on(const AppState &s) { return has_scene(s) && !at_end(s); }
/// Between two phases the worker is not busy for a moment, but has its goal still before it.
bool is_under_way(const AppState &s) {
    for (int pane = 0; pane < n_panes(s.layout); ++pane)
        if (has_scene(s) && !s.halted && !s.timeline(s.strategy_of(pane)).reached(s.asked_position(pane)))
            return true;
    return false;
}
bool can_cancel(const AppState &s) { return s.busy || s.playing || !s.opening.empty() || is_under_way(s); }

/// Esc leaves what is open, one thing at a time, before it stops the solver.
void cancel(AppState &s) {
    if (s.palette.open) {
        s.palette = {};
    } else if (s.script.playing) {
        s.script.playing = false;
        s.message = {"The script was stopped at its line " + std::to_string(s.script.line) + ".", false};
    } else if (s.help_open || s.open_dialog || s.pictures.settings_open) {
        s.help_open = s.open_dialog = s.pictures.settings_open = false;
    } else if (!s.pictures.pending.empty() || s.pictures.drawn) {
        drop_pictures(s);
    } else if (s.pinned_curve) {
        s.pinned_curve.reset();
    } else if (s.keyhole.open) {
        s.keyhole.open = false;
    } else if (s.truth.busy) {
        stop_judging(s);
    } else if (s.profile.open) {
        toggle_profile(s);
    } else if (s.shelf.checking) {
        stop_check(s);
    } else if (s.inspector != Inspector::none && !can_cancel(s)) {
        s.inspector = Inspector::none;
    } else if (can_cancel(s)) {
        s.cancel_request = true;
        s.halted = true;
        s.seeking = false;
        s.playing = false;
    } else if (s.tour.open) {
        s.tour.open = false;
    } else {
        s.message = {};
    }
}

void reset(AppState &s) {
    s.playing = false;
    go_to(s, 0);
    s.message = {"Back at the start.", false};
}

void toggle_play(AppState &s) {
    s.playing = !s.playing;
    s.play_until.reset();
    if (s.playing) {
        s.halted = false;
        s.hint_done = true;
    } else {
        s.message = {"Paused.", false};
    }
}

template <int to(int)>
void go(AppState &s) {
    s.playing = false;
    go_to(s, to(s.position));
}
constexpr int next_phase(int p) { return p + 1; }
constexpr int previous_phase(int p) { return p - 1; }
constexpr int to_the_end(int) { return far_ahead; }

template <void move(AppState &)>
void pause_and(AppState &s) {
    s.playing = false;
    move(s);
}
bool can_go_on_by_splits(const AppState &s) {
    return can_go_on(s) || shown_splits(s).value_or(n_splits(s)) < n_splits(s);
}
bool can_go_on_by_links(const AppState &s) {
    return can_go_on(s) || shown_splits(s) || shown_linkings(s).value_or(n_linkings(s)) < n_linkings(s);
}
template <int halvings>
void change_speed(AppState &s) {
    set_speed(s, std::ldexp(s.phases_per_second, halvings));
}
void toggle_animation(AppState &s) {
    s.animates_splits = !s.animates_splits;
    s.message = {s.animates_splits ? "Playing shows the splits of a refinement one by one."
                                   : "Playing shows the splits of a refinement all at once.",
                 false};
}

} // namespace

std::vector<Action> solve_actions() {
    return {
        {"solve.play", Menu::solve, "Play / pause", "Goes on by itself, a phase at a time, until converged.", {"Space"},
         toggle_play, has_scene, [](const AppState &s) { return s.playing; }},
        {"solve.step", Menu::solve, "Step", "One iteration: refine, gather, push and pull.", {"Right"},
         go<step_forward>, can_go_on},
        {"solve.sub_step", Menu::solve, "Next phase", "One phase alone: refine, or gather, or push and pull.",
         {"Shift+Right"}, go<next_phase>, can_go_on},
        {"solve.back", Menu::solve, "Back", "To the end of the iteration before.", {"Left"}, go<step_back>,
         can_go_back},
        {"solve.sub_back", Menu::solve, "Previous phase", "One phase back.", {"Shift+Left"}, go<previous_phase>,
         can_go_back},
        {"solve.split", Menu::solve, "Next split", "One split alone; where a refinement has no more, the next phase.",
         {"Ctrl+Right"}, pause_and<next_split>, can_go_on_by_splits},
        {"solve.split_back", Menu::solve, "Previous split", "One split back; before the first one, one phase.",
         {"Ctrl+Left"}, pause_and<previous_split>, can_go_back},
        {"solve.link", Menu::solve, "Next link", "One pair linked, after all splits; where a refinement has no more, the first of the next.",
         {"Ctrl+Down"}, pause_and<next_linking>, can_go_on_by_links},
        {"solve.link_back", Menu::solve, "Previous link", "One pair back; before the first one, the last split.",
         {"Ctrl+Up"}, pause_and<previous_linking>, can_go_back},
        {"solve.next_cut", Menu::solve, "To the next cut", "Goes on until an element was cut along a discontinuity curve.",
         {"Ctrl+Shift+Right"}, seek_cut, can_go_on_by_splits},
        {"solve.animate", Menu::solve, "Animate splits", "Playing shows the splits of each refinement one by one.",
         {"J"}, toggle_animation, nullptr, [](const AppState &s) { return s.animates_splits; }},
        {"solve.slower", Menu::solve, "Slower", "Halves the speed of playing.", {","}, change_speed<-1>,
         [](const AppState &s) { return s.phases_per_second > slowest_play; }},
        {"solve.faster", Menu::solve, "Faster", "Doubles the speed of playing.", {"."}, change_speed<1>,
         [](const AppState &s) { return s.phases_per_second < fastest_play; }},
        {"solve.reset", Menu::solve, "Reset", "Back to the start.", {"Home"}, reset, can_go_back},
        {"solve.end", Menu::solve, "To the end", "Iterates until nothing changes any more.", {"End"}, go<to_the_end>,
         can_go_on},
        {"solve.cancel", Menu::solve, "Cancel", "Stops the solver; the last complete state stays.", {"Escape"}, cancel},

        {"check.all", Menu::solve, "Check the hard cases", "Solves every case of the shelf in both bases and measures it.",
         {"Shift+H"}, check_shelf, [](const AppState &s) { return !s.shelf.checking; }},
        {"check.stop", Menu::solve, "Stop checking", "What has been measured stays.", {}, stop_check,
         [](const AppState &s) { return s.shelf.checking; }},

        {"effects.by_scene", Menu::solve, "What the scene calls for", "Leaves every effect's switch to the scene; starts anew.",
         {}, decide_by_scene, [](const AppState &s) { return has_scene(s) && !all_by_scene(s); }},
    };
}

} // namespace penumbra
