// The line that makes a picture again, to be run by a shell: "copy as command".
#pragma once

#include "files/saved_state.h"

#include <string>
#include <string_view>

namespace penumbra {

/// As a word of a POSIX shell: as it is where that is safe, else in single quotes.
std::string shell_word(std::string_view text);

/// "penumbra render SCENE ... -o NAME.png", with the options that differ from render's own. Numbers have all their
/// digits; the scene's file is named as the state has it. Run, it draws the same pixels, but for the seconds in the labels
/// (tests/golden/render_command_test.cpp, tests/gui/picture_test.cpp).
std::string render_command(const SavedState &state);

} // namespace penumbra
