// Looking at the emitters from a point of a receiver, while it is dragged.
#pragma once

#include "app_state.h"

namespace penumbra {

/// Opens the keyhole where the mouse is, or in the middle of the largest lit surface; closes it when it is open.
void toggle_keyhole(AppState &state);
/// Looks from there. When the way from where it was crosses a curve, that curve lights up for a moment and the news say
/// what has changed. Surfaces that do not reflect are not looked from.
void move_keyhole(AppState &state, int surface, const Vec3 &point);
/// How long the crossed curve will still be lit [s]; negative: it is not.
double crossing_glows(const AppState &state, Clock::time_point now);

} // namespace penumbra
