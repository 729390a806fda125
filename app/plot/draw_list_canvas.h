// Plots in a window or a picture, on an ImGui draw list.
#pragma once

#include "plot/canvas.h"
#include "render/labels.h"

namespace penumbra {

class DrawListCanvas final : public Canvas {
public:
    /// Keeps the list, which must outlive it.
    DrawListCanvas(ImDrawList &list, const Fonts &fonts) : list_(list), fonts_(fonts) {}

    void polyline(std::span<const glm::vec2> points, const PlotStroke &stroke) override;
    void fill(const PlotBox &box, const glm::vec4 &colour) override;
    void marker(glm::vec2 at, PlotMarker shape, float radius, const PlotStroke &outline,
                const glm::vec4 &inside) override;
    void text(glm::vec2 at, const std::string &words, const PlotText &style) override;
    float text_width(const std::string &words, const PlotText &style) const override;
    void clip(const PlotBox &box) override;
    void unclip() override;

private:
    const ImFont *font(const PlotText &style) const { return style.bold ? fonts_.bold : fonts_.text; }

    ImDrawList &list_;
    Fonts fonts_;
};

} // namespace penumbra
