// What an element holds: its coefficients, and the polynomial that they are.
#pragma once

#include "iteration/element_report.h"
#include "render/camera.h"
#include "render/look.h"

namespace penumbra {

/// Of all functions but the constant, a bar (or one for each channel where they differ) up or down from 0, in a box of this
/// size; the mouse reads them.
void draw_coefficient_bars(const ElementReport &report, float width, float height);

/// The patch in its true shape, turned as the camera sees it, coloured from its least to its largest value; in a square of
/// this side, with the two numbers below.
void draw_polynomial_map(const Snapshot &snapshot, int patch, const Camera &camera, const Look &look, float side);

} // namespace penumbra
