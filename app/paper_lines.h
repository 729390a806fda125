// What the paper calls the things that the window shows: symbol and equation, the last line of their tooltips.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace penumbra {

struct PaperLine {
    std::string_view name;   ///< of an action ("solve.step"), a control ("threshold") or a figure ("figure patches")
    std::string_view symbol; ///< "b = e + K b"
    std::string_view place;  ///< "equation (3)"
    bool of_others = false;  ///< the place is not in Bouatouch & Pattanaik 1995: "Heckbert 1992"
};

std::span<const PaperLine> paper_lines();

/// "b = e + K b   (Bouatouch & Pattanaik 1995, equation (3))"; empty where there is none of that name. Checked by
/// tests/gui/tooltips_test.cpp.
std::string paper_line(std::string_view name);

} // namespace penumbra
