// What a bundled scene says of itself in its first comments:
//   # penumbra: one line of description
//   # view: ex ey ez tx ty tz fov
// Other programs take them for comments.
#pragma once

#include "scene/scene.h"

#include <string_view>

namespace penumbra {

struct ObjHeader {
    std::string description;
    std::optional<View> view;
};

/// Reads the comment lines that `text` begins with. A view that is not seven finite numbers, with two distinct points
/// and an angle between 0 and 180 degrees, counts as none.
ObjHeader read_obj_header(std::string_view text);

/// "ex ey ez tx ty tz fov", as the option --view has it too.
std::optional<View> view_from(std::string_view words);

} // namespace penumbra
