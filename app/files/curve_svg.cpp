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

/// Regions', so quiet that the curves' colours stand out; seldom more than four are needed.
constexpr std::array<const char *, 6> tints{"#f4f4f0", "#e3e9ee", "#efe7dc", "#e0ebe1", "#ece3ec", "#d9d9d9"};

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

/// A tint for each region: the first that no neighbour with a smaller number has.
std::vector<std::size_t> tint_numbers(const Arrangement &arrangement) {
    std::vector<std::vector<std::size_t>> smaller(arrangement.faces.size());
    for (const ArrangementEdge &e : arrangement.edges)
        if (e.left >= 0 && e.right >= 0 && e.left != e.right)
            smaller[static_cast<std::size_t>(std::max(e.left, e.right))].push_back(
                static_cast<std::size_t>(std::min(e.left, e.right)));
    std::vector<std::size_t> chosen;
    for (const std::vector<std::size_t> &neighbours : smaller) {
        std::size_t tint = 0;
        while (std::ranges::any_of(neighbours, [&](std::size_t n) { return chosen[n] == tint; }))
            ++tint;
        chosen.push_back(tint);
    }
    return chosen;
}

std::string regions(const Page &page, const Arrangement &arrangement) {
    const auto cycle = [&](const std::vector<int> &vertices) {
        std::vector<Vec2> line;
        for (const int v : vertices)
            line.push_back(arrangement.vertices[static_cast<std::size_t>(v)]);
        return "M" + page.points(line) + "Z";
    };
    const std::vector<std::size_t> tint = tint_numbers(arrangement);
    std::string text;
    for (std::size_t f = 0; f < arrangement.faces.size(); ++f) {
        std::string path = cycle(arrangement.faces[f].outline);
        for (const std::vector<int> &hole : arrangement.faces[f].holes)
            path += cycle(hole);
        text += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", path, tints[std::min(tint[f], tints.size() - 1)]);
    }
    return text;
}

} // namespace

std::pair<std::string, std::string> curve_drawing(const Snapshot &snapshot, const ReceiverCurves &curves) {
    const SnapshotSurface &surface = snapshot.surfaces[static_cast<std::size_t>(curves.receiver)];
    const Page page(surface.outline);
    std::set<std::pair<std::int32_t, std::int32_t>> used;
    std::string lines;
    for (std::size_t i = 0; i < curves.curves.size(); ++i) {
        const SnapshotCurve &curve = (*snapshot.curves)[curves.curves[i]];
        used.emplace(curve.kind, curve.order);
        lines += fmt::format("<polyline points=\"{}\" stroke=\"{}\" {}/>\n", page.points(curves.lines[i]),
                             colours.at(static_cast<std::size_t>(curve.kind)),
                             strokes.at(static_cast<std::size_t>(curve.order)));
    }
    const double full = page.height() + legend_row * static_cast<double>(used.size() + 2);
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" "
                                  "viewBox=\"0 0 {0} {1:.0f}\" font-family=\"sans-serif\" font-size=\"13\">\n"
                                  "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
                                  "<g fill-rule=\"evenodd\" stroke=\"#bbb\" stroke-width=\"0.3\">\n{2}</g>\n"
                                  "<polygon points=\"{3}\" fill=\"none\" stroke=\"#555\"/>\n"
                                  "<g fill=\"none\" stroke-linejoin=\"round\">\n{4}</g>\n",
                                  width, full, regions(page, curves.arrangement), page.points(surface.outline), lines);
    double y = page.height() + legend_row / 2;
    const std::size_t n = curves.arrangement.faces.size();
    svg += fmt::format(
        "<text x=\"{}\" y=\"{:.0f}\">{}, surface {} ({}): {} region{}, each of one tint: inside, irradiance "
        "is smooth</text>\n",
        border, y, escaped(snapshot.scene), curves.receiver, escaped(surface.name), n, n == 1 ? "" : "s");
    for (const auto &[kind, order] : used) {
        y += legend_row;
        svg += fmt::format("<line x1=\"{}\" y1=\"{:.0f}\" x2=\"{}\" y2=\"{:.0f}\" stroke=\"{}\" {}/>"
                           "<text x=\"{}\" y=\"{:.0f}\">{}: {}</text>\n",
                           border, y - 4, border + 40, y - 4, colours.at(static_cast<std::size_t>(kind)),
                           strokes.at(static_cast<std::size_t>(order)), border + 50, y,
                           name(static_cast<CurveKind>(kind)), orders.at(static_cast<std::size_t>(order)));
    }
    return {fmt::format("receiver-{}.svg", curves.receiver), svg + "</svg>\n"};
}

} // namespace penumbra
