#include "window/keys.h"

#include <GLFW/glfw3.h>

#include <cctype>
#include <string_view>

namespace penumbra {

namespace {

std::string_view named(int key) {
    switch (key) {
    case GLFW_KEY_SPACE: return "Space";
    case GLFW_KEY_ESCAPE: return "Escape";
    case GLFW_KEY_TAB: return "Tab";
    case GLFW_KEY_LEFT: return "Left";
    case GLFW_KEY_RIGHT: return "Right";
    case GLFW_KEY_UP: return "Up";
    case GLFW_KEY_DOWN: return "Down";
    case GLFW_KEY_HOME: return "Home";
    case GLFW_KEY_END: return "End";
    case GLFW_KEY_PAGE_UP: return "PageUp";
    case GLFW_KEY_PAGE_DOWN: return "PageDown";
    case GLFW_KEY_KP_ADD: return "+";
    case GLFW_KEY_KP_SUBTRACT: return "-";
    default: return {};
    }
}

std::string base_name(int key, int scancode) {
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return std::string("F").append(std::to_string(key - GLFW_KEY_F1 + 1));
    if (const auto name = named(key); !name.empty())
        return std::string(name);
    const char *layout = glfwGetKeyName(key, scancode);
    std::string text = layout ? layout : "";
    if (text.size() == 1)
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
}

} // namespace

std::string key_word(int key, int scancode, int mods) {
    std::string word = base_name(key, scancode);
    if (word.empty())
        return {};
    const bool letter = word.size() == 1 && std::isalpha(static_cast<unsigned char>(word[0]));
    const bool sign = word.size() == 1 && !letter;
    if (sign && !(mods & GLFW_MOD_CONTROL))
        return {};
    std::string modifiers;
    if (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER))
        modifiers += "Ctrl+";
    if (mods & GLFW_MOD_ALT)
        modifiers += "Alt+";
    if ((mods & GLFW_MOD_SHIFT) && !sign)
        modifiers += "Shift+";
    return modifiers.append(word);
}

std::string text_key(unsigned int codepoint) {
    if (codepoint >= 128 || !std::isgraph(static_cast<int>(codepoint)) || std::isalpha(static_cast<int>(codepoint)))
        return {};
    return std::string(1, static_cast<char>(codepoint));
}

} // namespace penumbra
