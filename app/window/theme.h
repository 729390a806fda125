// How the interface looks: quiet greys, so that the scene is the brightest thing in the window, and one warm accent.
#pragma once

#include "render/look.h"

namespace penumbra {

/// Sets ImGui's colours, and its distances for this text height [screen coordinates].
void set_theme(Theme theme, float text_height);

} // namespace penumbra
