// Plots as SVG text.
#pragma once

#include "plot/canvas.h"

namespace penumbra {

class SvgCanvas final : public Canvas {
public:
    SvgCanvas(float width, float height) : width_(width), height_(height) {}

    void polyline(std::span<const glm::vec2> points, const PlotStroke &stroke) override;
    void fill(const PlotBox &box, const glm::vec4 &colour) override;
    void marker(glm::vec2 at, PlotMarker shape, float radius, const PlotStroke &outline,
                const glm::vec4 &inside) override;
    void text(glm::vec2 at, const std::string &words, const PlotText &style) override;
    /// Estimated: readers have different fonts.
    float text_width(const std::string &words, const PlotText &style) const override;
    void clip(const PlotBox &box) override;
    void unclip() override;

    /// The whole file.
    std::string file() const;

private:
    float width_, height_;
    int n_clips_ = 0;
    std::string body_;
};

} // namespace penumbra
