// What stands between two solutions that are wiped over one another, in the window and in pictures.
#pragma once

#include <imgui.h>

#include <algorithm>

namespace penumbra {

/// An upright line with its middle at `x`, light in a dark border, to be seen on anything; `em`: text height [pixels].
void draw_divider(ImDrawList &list, float x, float top, float bottom, float em);
/// The knob in its middle, by which the mouse takes it.
void draw_divider_knob(ImDrawList &list, float x, float y, float em);

/// The share of the width that the label on the left has, the other one having the rest: both are readable wherever the
/// divider stands.
constexpr double label_share(double wipe) { return std::clamp(wipe, 0.3, 0.7); }

} // namespace penumbra
