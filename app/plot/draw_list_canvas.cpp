#include "plot/draw_list_canvas.h"

#include "plot/dashes.h"

namespace penumbra {

namespace {

ImVec2 to_imgui(glm::vec2 p) { return {p.x, p.y}; }
ImU32 to_imgui(const glm::vec4 &c) { return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a}); }

std::vector<ImVec2> to_imgui(std::span<const glm::vec2> points) {
    std::vector<ImVec2> all;
    for (const glm::vec2 &p : points)
        all.push_back(to_imgui(p));
    return all;
}

} // namespace

void DrawListCanvas::polyline(std::span<const glm::vec2> points, const PlotStroke &stroke) {
    const auto draw = [&](std::span<const glm::vec2> line) {
        const std::vector<ImVec2> all = to_imgui(line);
        list_.AddPolyline(all.data(), static_cast<int>(all.size()), to_imgui(stroke.colour), 0, stroke.width);
    };
    if (stroke.dash <= 0)
        return draw(points);
    for (const std::vector<glm::vec2> &dash : dashes(points, stroke.dash, 0.7f * stroke.dash))
        draw(dash);
}

void DrawListCanvas::fill(const PlotBox &box, const glm::vec4 &colour) {
    list_.AddRectFilled(to_imgui(box.low), to_imgui(box.high), to_imgui(colour));
}

void DrawListCanvas::marker(glm::vec2 at, PlotMarker shape, float radius, const PlotStroke &outline,
                            const glm::vec4 &inside) {
    const std::vector<ImVec2> corners = to_imgui(std::span<const glm::vec2>(marker_corners(at, shape, radius)));
    const ImU32 colour = to_imgui(outline.colour);
    if (shape == PlotMarker::cross) {
        list_.AddLine(corners[0], corners[1], colour, outline.width);
        list_.AddLine(corners[2], corners[3], colour, outline.width);
        return;
    }
    list_.AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), to_imgui(inside));
    list_.AddPolyline(corners.data(), static_cast<int>(corners.size()), colour, ImDrawFlags_Closed, outline.width);
}

void DrawListCanvas::text(glm::vec2 at, const std::string &words, const PlotText &style) {
    const float share = style.align == TextAlign::left ? 0 : style.align == TextAlign::centre ? 0.5f : 1;
    const float x = at.x - share * text_width(words, style);
    list_.AddText(font(style), style.size, {x, at.y - 0.5f * style.size}, to_imgui(style.colour), words.c_str());
}

float DrawListCanvas::text_width(const std::string &words, const PlotText &style) const {
    return font(style)->CalcTextSizeA(style.size, 1e9f, 0, words.c_str()).x;
}

void DrawListCanvas::clip(const PlotBox &box) { list_.PushClipRect(to_imgui(box.low), to_imgui(box.high), true); }
void DrawListCanvas::unclip() { list_.PopClipRect(); }

} // namespace penumbra
