#include "render/profile_mark.h"

#include <cmath>

namespace penumbra {

void draw_profile_mark(ImDrawList &list, const Fonts &fonts, ImVec2 low, ImVec2 high, const Camera &camera,
                       const ProfileLine &line, std::optional<double> at, const char *letters) {
    const float width = high.x - low.x, height = high.y - low.y, em = fonts.size;
    const auto on_screen = [&](const Vec3 &p) -> std::optional<ImVec2> {
        const auto place = place_in_frame(camera, static_cast<double>(width / height), {p.x(), p.y(), p.z()});
        if (!place)
            return std::nullopt;
        return ImVec2(low.x + width * static_cast<float>(0.5 + 0.5 * place->x),
                      low.y + height * static_cast<float>(0.5 - 0.5 * place->y));
    };
    const auto a = on_screen(line.from), b = on_screen(line.to);
    if (!a || !b)
        return;
    constexpr ImU32 dark = IM_COL32(10, 12, 16, 230), bright = IM_COL32(255, 255, 255, 255);
    list.PushClipRect(low, high, true);
    list.AddLine(*a, *b, dark, 0.26f * em);
    list.AddLine(*a, *b, bright, 0.12f * em);
    // Letters stand beyond the ends, in the line's direction.
    const float length = std::max(1.f, std::hypot(b->x - a->x, b->y - a->y));
    const ImVec2 way((b->x - a->x) / length, (b->y - a->y) / length);
    const auto end = [&](const ImVec2 &p, float sign, char name) {
        const char letter[] = {name, 0};
        list.AddCircleFilled(p, 0.3f * em, dark);
        list.AddCircleFilled(p, 0.2f * em, bright);
        const ImVec2 centre(p.x + sign * 1.05f * em * way.x, p.y + sign * 1.05f * em * way.y);
        const ImVec2 size = fonts.bold->CalcTextSizeA(em, 1e9f, 0, letter);
        list.AddCircleFilled(centre, 0.68f * em, dark);
        list.AddText(fonts.bold, em, {centre.x - size.x / 2, centre.y - size.y / 2}, bright, letter);
    };
    end(*a, -1, letters[0]);
    end(*b, 1, letters[1]);
    if (at)
        if (const auto here = on_screen(line.at(*at))) {
            list.AddCircle(*here, 0.42f * em, dark, 0, 0.28f * em);
            list.AddCircle(*here, 0.42f * em, IM_COL32(255, 200, 60, 255), 0, 0.14f * em);
        }
    list.PopClipRect();
}

} // namespace penumbra
