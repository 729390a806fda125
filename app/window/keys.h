// Key presses as words, so that the registry of actions, the help page and the tests speak of them alike.
#pragma once

#include <string>

namespace penumbra {

/// "Shift+Right", "Ctrl+F12", "E" for a GLFW key event; letters and signs by the user's keyboard layout. Empty for keys
/// that come as text instead (digits and signs without Ctrl, see text_key) and for modifiers alone.
std::string key_word(int key, int scancode, int mods);

/// "1", "?" for a character that was typed; empty for letters (they come as keys) and all else.
std::string text_key(unsigned int codepoint);

} // namespace penumbra
