#include "files/curve_svg.h"

#include "discontinuity/curve.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>

namespace penumbra {

namespace {

constexpr double width = 800, border = 20, legend_row = 18;

/// Okabe and Ito's colours, which colour-blind people tell apart; by CurveKind.
constexpr std::array<const char *, 5> colours{"#0072B2", "#E69F00", "#CC79A7", "#009E73", "#D55E00"};
constexpr std::array<const char *, 3> strokes{"stroke-width=\"3\"", "stroke-width=\"1.5\"",
                                              "stroke-width=\"1.5\" stroke-dasharray=\"6 3\""};
constexpr std::array<const char *, 3> orders{"irradiance jumps", "its slope jumps", "its curvature jumps"};

/// From a surface's plane to the page, y downwards.
struct Page {
    Vec2 low, high;
    double scale;

    explicit Page(const std::vector<Vec2> &outline) : low(outline[0]), high(outline[0]) {
        for (const Vec2 &p : outline) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        scale = (width - 2 * border) / std::max((high - low).x(), 1e-3 * (high - low).y());
    }
    double height() const { return (high - low).y() * scale + 2 * border; }
    std::string points(const std::vector<Vec2> &line) const {
        std::string text;
        for (const Vec2 &p : line)
            text += fmt::format("{}{:.3f},{:.3f}", text.empty() ? "" : " ", border + (p.x() - low.x()) * scale,
                                border + (high.y() - p.y()) * scale);
        return text;
    }
};

std::string escaped(const std::string &text) {
    std::string out;
    for (const char c : text)
        out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
    return out;
}

std::string drawing(const Snapshot &snapshot, std::int32_t receiver) {
    const SnapshotSurface &surface = snapshot.surfaces[static_cast<std::size_t>(receiver)];
    const Page page(surface.outline);
    std::set<std::pair<std::int32_t, std::int32_t>> used;
    std::string lines;
    for (const SnapshotCurve &curve : *snapshot.curves) {
        if (curve.receiver != receiver)
            continue;
        used.emplace(curve.kind, curve.order);
        std::vector<Vec2> flat;
        for (const Vec3 &x : curve.points)
            flat.emplace_back((x - surface.origin).dot(surface.u), (x - surface.origin).dot(surface.v));
        lines += fmt::format("<polyline points=\"{}\" stroke=\"{}\" {}/>\n", page.points(flat),
                             colours.at(static_cast<std::size_t>(curve.kind)),
                             strokes.at(static_cast<std::size_t>(curve.order)));
    }
    const double full = page.height() + legend_row * static_cast<double>(used.size() + 2);
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" "
                                  "viewBox=\"0 0 {0} {1:.0f}\" font-family=\"sans-serif\" font-size=\"13\">\n"
                                  "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
                                  "<polygon points=\"{2}\" fill=\"#f2f2f2\" stroke=\"#555\"/>\n"
                                  "<g fill=\"none\" stroke-linejoin=\"round\">\n{3}</g>\n",
                                  width, full, page.points(surface.outline), lines);
    double y = page.height() + legend_row / 2;
    svg += fmt::format("<text x=\"{}\" y=\"{:.0f}\">{}, surface {} ({})</text>\n", border, y, escaped(snapshot.scene),
                       receiver, escaped(surface.name));
    for (const auto &[kind, order] : used) {
        y += legend_row;
        svg += fmt::format("<line x1=\"{}\" y1=\"{:.0f}\" x2=\"{}\" y2=\"{:.0f}\" stroke=\"{}\" {}/>"
                           "<text x=\"{}\" y=\"{:.0f}\">{}: {}</text>\n",
                           border, y - 4, border + 40, y - 4, colours.at(static_cast<std::size_t>(kind)),
                           strokes.at(static_cast<std::size_t>(order)), border + 50, y,
                           name(static_cast<CurveKind>(kind)), orders.at(static_cast<std::size_t>(order)));
    }
    return svg + "</svg>\n";
}

} // namespace

std::vector<std::pair<std::string, std::string>> curve_drawings(const Snapshot &snapshot) {
    std::set<std::int32_t> receivers;
    for (const SnapshotCurve &curve : *snapshot.curves)
        receivers.insert(curve.receiver);
    std::vector<std::pair<std::string, std::string>> drawings;
    for (const std::int32_t r : receivers)
        drawings.emplace_back(fmt::format("receiver-{}.svg", r), drawing(snapshot, r));
    return drawings;
}

} // namespace penumbra
