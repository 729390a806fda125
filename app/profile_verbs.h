// The radiosity along a line that is dragged over a surface.
#pragma once

#include "app_state.h"
#include "truth_worker.h"

namespace penumbra {

/// Opens the plot, with a line across the middle of the largest lit surface unless there is one; closes it when it is
/// open.
void toggle_profile(AppState &state);
/// The line from one point of a surface to another. Nothing happens where they are one.
void set_profile(AppState &state, int surface, const Vec3 &from, const Vec3 &to);
/// Follows line, panes and truth; called once a frame.
void update_profile(AppState &state);
/// What the truth is asked for; nothing where there is no line, or its truth is known.
std::optional<ProfileQuestion> profile_question(const AppState &state);

} // namespace penumbra
