// What does not fit where it is drawn.
#pragma once

#include <string>
#include <vector>

namespace penumbra {

/// Of ImGui's windows of this frame, a phrase for each that reaches beyond the display, or that holds more than it shows and
/// cannot be scrolled there. Whatever stands in a window that scrolls upright can be reached.
std::vector<std::string> cut_windows();

} // namespace penumbra
