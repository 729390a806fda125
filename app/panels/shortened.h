// Text in places of a given width.
#pragma once

#include <string>

namespace penumbra {

/// As much of the text as fits; where that is not all, it ends in an ellipsis.
std::string shortened(std::string text, float width);

} // namespace penumbra
