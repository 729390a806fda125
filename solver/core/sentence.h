// Words as a sentence.
#pragma once

#include <cctype>
#include <string>

namespace penumbra {

/// "no surface emits" as "No surface emits."
inline std::string as_sentence(std::string words) {
    if (!words.empty())
        words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    return words + ".";
}

} // namespace penumbra
