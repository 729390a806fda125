// Saved states, read back.
#pragma once

#include "files/saved_state.h"

#include <string>
#include <string_view>

namespace penumbra {

inline constexpr std::size_t largest_state = std::size_t{1} << 20; ///< bytes; nesting at most 16, values at most 20 000
inline constexpr int most_panes = 16, largest_picture = 16384, smallest_picture = 64, most_supersampling = 4;

/// Reads the text of a state; `file` is what messages call it. Fields that are missing (all but `scene` may be) have
/// the program's defaults, unknown ones are passed over; a text of a later format is read as far as it is understood,
/// with a note. Throws BadInput, one line with file, field, value and remedy. Whatever it returns can be drawn: numbers
/// are finite and in range, the eye is not in its target and does not look along its up. Whether surfaces, curves and
/// points that it names are there is for the caller, who has the scene.
SavedState read_state(const std::string &file, std::string_view text);

} // namespace penumbra
