// A plot as a picture, on the same off-screen path as pictures of scenes.
#pragma once

#include "capture.h"
#include "plot/canvas.h"
#include "render/look.h"

#include <functional>

namespace penumbra {

/// Draws in the current context into a framebuffer of its own and reads it back; leaves the bound framebuffer and the
/// ImGui context as they were. `text`: text height that the fonts are made for [pixels].
Image draw_plot_picture(int width, int height, float text, Theme theme, const std::function<void(Canvas &)> &draw);

} // namespace penumbra
