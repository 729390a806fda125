#include "panels/shortened.h"

#include <imgui.h>

namespace penumbra {

std::string shortened(std::string text, float width) {
    if (ImGui::CalcTextSize(text.c_str()).x <= width)
        return text;
    while (!text.empty() && ImGui::CalcTextSize((text + "\u2026").c_str()).x > width) {
        while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) // inside a character
            text.pop_back();
        text.pop_back();
    }
    return text + "\u2026";
}

} // namespace penumbra
