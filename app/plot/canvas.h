// What a plot is drawn with: a handful of primitives that the window, a picture and an SVG file all have.
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <string>
#include <vector>

namespace penumbra {

/// An upright rectangle [pixels, y downward].
struct PlotBox {
    glm::vec2 low{0}, high{0};

    float width() const { return high.x - low.x; }
    float height() const { return high.y - low.y; }
    bool contains(glm::vec2 p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
};

enum class PlotMarker { circle, square, triangle, diamond, cross };
enum class TextAlign { left, centre, right };

struct PlotStroke {
    glm::vec4 colour{0, 0, 0, 1}; ///< sRGB
    float width = 1;
    float dash = 0; ///< length of a dash; the gap is 0.7 of it; 0: solid
};

struct PlotText {
    float size = 15;
    glm::vec4 colour{0, 0, 0, 1}; ///< sRGB
    TextAlign align = TextAlign::left;
    bool bold = false;
};

class Canvas {
public:
    virtual ~Canvas() = default;

    virtual void polyline(std::span<const glm::vec2> points, const PlotStroke &stroke) = 0;
    virtual void fill(const PlotBox &box, const glm::vec4 &colour) = 0;
    /// `radius`: of the circle; other shapes look as large. A hollow one is filled with `inside`. A cross has no inside.
    virtual void marker(glm::vec2 at, PlotMarker shape, float radius, const PlotStroke &outline,
                        const glm::vec4 &inside) = 0;
    /// `at` is the left end, the middle or the right end, half-way up the letters.
    virtual void text(glm::vec2 at, const std::string &words, const PlotText &style) = 0;
    virtual float text_width(const std::string &words, const PlotText &style) const = 0;
    /// Until unclip() nothing is drawn outside. They do not nest.
    virtual void clip(const PlotBox &box) = 0;
    virtual void unclip() = 0;

    void line(glm::vec2 a, glm::vec2 b, const PlotStroke &stroke) {
        const glm::vec2 ends[] = {a, b};
        polyline(ends, stroke);
    }
};

/// Corners of a marker of this radius, counter-clockwise on the page; a circle has 24. A cross: the ends of its first
/// stroke, then of the second.
std::vector<glm::vec2> marker_corners(glm::vec2 at, PlotMarker shape, float radius);

} // namespace penumbra
