#include "render/event_note.h"

#include <algorithm>

namespace penumbra {

ImVec2 draw_event_note(ImDrawList *list, const Fonts &fonts, ImVec2 corner, float width, const EventWords &words,
                       ImVec4 colour, Theme theme) {
    const float em = fonts.size, pad = 0.6f * em, bar = 0.3f * em, wrap = width - 2 * pad - bar;
    const std::string plain = words.sentence + " " + words.jump,
                      symbols = words.symbol + (words.way.empty() ? "" : "  \u00b7  " + words.way);
    const auto size_of = [&](const std::string &text) {
        return fonts.text->CalcTextSizeA(em, 1e9f, wrap, text.c_str());
    };
    const ImVec2 first = size_of(plain), second = size_of(symbols);
    const float below = symbols.empty() ? 0 : 0.3f * em + second.y;
    const ImVec2 size{std::max(first.x, second.x) + 2 * pad + bar, first.y + below + 2 * pad};
    if (!list)
        return size;
    const ImVec2 low{corner.x, corner.y - size.y}, high{low.x + size.x, corner.y};
    const bool dark = theme == Theme::dark;
    const ImU32 ink = dark ? IM_COL32(237, 240, 245, 255) : IM_COL32(18, 20, 26, 255);
    const ImU32 quiet = dark ? IM_COL32(237, 240, 245, 175) : IM_COL32(18, 20, 26, 185);
    list->AddRectFilled(low, high, dark ? IM_COL32(20, 23, 28, 235) : IM_COL32(250, 250, 250, 240), 0.25f * em);
    list->AddRectFilled(low, {low.x + bar, high.y}, ImGui::ColorConvertFloat4ToU32(colour), 0.25f * em);
    const float x = low.x + bar + pad;
    list->AddText(fonts.text, em, {x, low.y + pad}, ink, plain.c_str(), nullptr, wrap);
    list->AddText(fonts.text, em, {x, low.y + pad + first.y + 0.3f * em}, quiet, symbols.c_str(), nullptr, wrap);
    return size;
}

} // namespace penumbra
