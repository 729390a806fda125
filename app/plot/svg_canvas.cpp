#include "plot/svg_canvas.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace penumbra {

namespace {

std::string escaped(const std::string &text) {
    std::string out;
    for (const char c : text)
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    return out;
}

/// ImGui's text heights are from the highest to the lowest letter, SVG's are the em.
constexpr float em_of_height = 0.86f;

int byte(float channel) { return static_cast<int>(std::lround(255 * std::clamp(channel, 0.f, 1.f))); }

/// fill="#aabbcc", with an opacity where it is not whole.
std::string paint(const char *attribute, const glm::vec4 &c) {
    std::string text = fmt::format("{}=\"#{:02x}{:02x}{:02x}\"", attribute, byte(c.r), byte(c.g), byte(c.b));
    if (c.a < 1)
        text += fmt::format(" {}-opacity=\"{:.3g}\"", attribute, c.a);
    return text;
}

std::string pen(const PlotStroke &stroke) {
    std::string text = fmt::format("{} stroke-width=\"{:.2f}\"", paint("stroke", stroke.colour), stroke.width);
    if (stroke.dash > 0)
        text += fmt::format(" stroke-dasharray=\"{:.2f} {:.2f}\"", stroke.dash, 0.7f * stroke.dash);
    return text;
}

std::string coordinates(std::span<const glm::vec2> points) {
    std::string text;
    for (const glm::vec2 &p : points)
        text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? "" : " ", p.x, p.y);
    return text;
}

} // namespace

void SvgCanvas::polyline(std::span<const glm::vec2> points, const PlotStroke &stroke) {
    body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", coordinates(points), pen(stroke));
}

void SvgCanvas::fill(const PlotBox &box, const glm::vec4 &colour) {
    body_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n", box.low.x,
                         box.low.y, box.width(), box.height(), paint("fill", colour));
}

void SvgCanvas::marker(glm::vec2 at, PlotMarker shape, float radius, const PlotStroke &outline,
                       const glm::vec4 &inside) {
    const std::vector<glm::vec2> corners = marker_corners(at, shape, radius);
    if (shape == PlotMarker::cross) {
        line(corners[0], corners[1], outline);
        line(corners[2], corners[3], outline);
    } else if (shape == PlotMarker::circle) {
        body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {} {}/>\n", at.x, at.y, radius,
                             paint("fill", inside), pen(outline));
    } else {
        body_ += fmt::format("<polygon points=\"{}\" {} {}/>\n", coordinates(corners), paint("fill", inside),
                             pen(outline));
    }
}

void SvgCanvas::text(glm::vec2 at, const std::string &words, const PlotText &style) {
    constexpr const char *anchors[] = {"start", "middle", "end"};
    body_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" text-anchor=\"{}\"{} {}>{}</text>\n",
                         at.x, at.y + 0.31f * style.size, em_of_height * style.size, anchors[static_cast<int>(style.align)],
                         style.bold ? " font-weight=\"bold\"" : "", paint("fill", style.colour), escaped(words));
}

float SvgCanvas::text_width(const std::string &words, const PlotText &style) const {
    // DejaVu Sans' letters are 0.6 em wide in the mean. Bytes that go on with a letter do not count.
    const auto n = std::ranges::count_if(words, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
    return (style.bold ? 0.68f : 0.6f) * em_of_height * style.size * static_cast<float>(n);
}

void SvgCanvas::clip(const PlotBox &box) {
    ++n_clips_;
    body_ += fmt::format("<clipPath id=\"clip{0}\"><rect x=\"{1:.2f}\" y=\"{2:.2f}\" width=\"{3:.2f}\" "
                         "height=\"{4:.2f}\"/></clipPath>\n<g clip-path=\"url(#clip{0})\">\n",
                         n_clips_, box.low.x, box.low.y, box.width(), box.height());
}

void SvgCanvas::unclip() { body_ += "</g>\n"; }

std::string SvgCanvas::file() const {
    return fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 "
                       "{0:.0f} {1:.0f}\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n{2}</svg>\n",
                       width_, height_, body_);
}

} // namespace penumbra
