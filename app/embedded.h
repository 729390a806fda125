// Files that travel inside the program: shaders and fonts.
#pragma once

#include <string_view>

namespace penumbra {

/// Bytes of an embedded file by its path in the source tree ("shaders/lines.vert"). Asking for one that was not
/// embedded is a bug and stops the program.
std::string_view embedded(std::string_view path);

} // namespace penumbra
