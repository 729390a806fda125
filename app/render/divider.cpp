#include "render/divider.h"

namespace penumbra {

namespace {

constexpr ImU32 light = IM_COL32(255, 255, 255, 235), dark = IM_COL32(0, 0, 0, 150);

} // namespace

void draw_divider(ImDrawList &list, float x, float top, float bottom, float em) {
    const float half = std::max(0.5f, 0.05f * em);
    list.AddRectFilled({x - 2 * half, top}, {x + 2 * half, bottom}, dark);
    list.AddRectFilled({x - half, top}, {x + half, bottom}, light);
}

void draw_divider_knob(ImDrawList &list, float x, float y, float em) {
    const float r = 0.85f * em, near = 0.22f * r, far = 0.62f * r, high = 0.34f * r;
    list.AddCircleFilled({x, y}, r + 0.1f * em, dark);
    list.AddCircleFilled({x, y}, r, light);
    const ImU32 ink = IM_COL32(40, 44, 52, 255);
    list.AddTriangleFilled({x - far, y}, {x - near, y - high}, {x - near, y + high}, ink);
    list.AddTriangleFilled({x + far, y}, {x + near, y + high}, {x + near, y - high}, ink);
}

} // namespace penumbra
