// What can be done to the state; every action, button and key ends in one of these.
#pragma once

#include "app_state.h"
#include "solve_worker.h"

#include <optional>

namespace penumbra {

/// Where the worker should stand, for a pending picture first; nothing when there is no scene or the user has cancelled.
std::optional<Goal> goal(const AppState &state);

/// Asks for another position (never below 0), for all panes, or for the active one where panes have their own. Beyond the end of every shown solution there is nothing:
/// the position stays there and the message says why.
void go_to(AppState &state, int position);
/// A position beyond any number of iterations; the state stays at the end once that is known.
inline constexpr int far_ahead = 1'000'000;
/// Whether every strategy that steps has come to its end at or before the position.
bool at_end(const AppState &state);
/// Goes on by one phase when playing, all panes have arrived and the pace allows. Returns how long to wait until it
/// should be asked again [s]; negative: no need to.
double advance_play(AppState &state, Clock::time_point now);

/// Of playing; held between the two [phases or splits a second].
void set_speed(AppState &state, double steps_per_second);

/// Throws away what was computed and starts anew with these options; the position asked for stays.
void set_options(AppState &state, const Options &options);
/// The same; what had come to its end goes to the end again, which may take more steps.
void start_again(AppState &state, const Options &options);
/// Solves this scene from now on. What lies on surfaces of the one before is let go: keyhole, profile, curves, errors.
void set_scene(AppState &state, std::shared_ptr<const Scene> scene);
/// The same where only objects have moved: keyhole, profile and what is picked stay where they are.
void replace_scene(AppState &state, std::shared_ptr<const Scene> scene);
/// Shows this strategy in the active pane.
void set_strategy(AppState &state, Strategy strategy);
/// Draws the active pane's constants as quadratics, or as they are again.
void toggle_reconstruction(AppState &state);
void reset_view(AppState &state);
void fit_view(AppState &state);

constexpr Strategy strategy_of(bool cuts, bool constant) {
    return cuts ? (constant ? Strategy::discontinuity_constant : Strategy::discontinuity_wavelet)
                : (constant ? Strategy::uniform_constant : Strategy::uniform_wavelet);
}
/// (a) to (d), as the paper calls the strategies.
constexpr const char *letter(Strategy s) {
    constexpr const char *letters[] = {"a", "b", "c", "d"};
    return letters[static_cast<std::size_t>(s)];
}

/// The curve that stands out: the one that the keyhole has just crossed, or the pinned one, or the one under the mouse.
Spotlight spotlight(const AppState &state);

/// Takes over what the worker says. Reports of an earlier run are dropped.
void apply(AppState &state, const Report &report);

} // namespace penumbra
