#include "render/keyhole_inset.h"

#include "render/event_words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace penumbra {
namespace {

constexpr ImU32 night = IM_COL32(13, 15, 19, 255), silhouette = IM_COL32(58, 63, 73, 255),
                silhouette_edge = IM_COL32(128, 136, 150, 255), hidden_edge = IM_COL32(240, 175, 70, 150),
                lit = IM_COL32(255, 243, 208, 255), dot = IM_COL32(0, 114, 178, 255),
                dot_rim = IM_COL32(255, 255, 255, 255);

ImU32 ink(Theme theme, int opacity = 255) {
    return theme == Theme::dark ? IM_COL32(237, 240, 245, opacity) : IM_COL32(18, 20, 26, opacity);
}

struct Grid {
    std::size_t n = 0; ///< pictures
    int columns = 1, rows = 1;
    float side = 0;    ///< of a picture
    float caption = 0; ///< height
    float head = 0, foot = 0, pad = 0;
};

/// They stand before the hidden ones.
std::size_t n_visible(const Keyhole &keyhole) {
    return static_cast<std::size_t>(
        std::ranges::count_if(keyhole.emitters, [](const KeyholeEmitter &e) { return e.share > 0; }));
}

/// "and 3 more, less bright, and 2 hidden ones"; empty when all have a picture.
std::string others(const Keyhole &keyhole, std::size_t n_pictures) {
    const std::size_t visible = std::max(n_pictures, n_visible(keyhole)), hidden = keyhole.emitters.size() - visible;
    std::string text = visible > n_pictures ? "and " + std::to_string(visible - n_pictures) + " more, less bright" : "";
    if (hidden > 0)
        text += (text.empty() ? "and " : ", and ") + std::to_string(hidden) +
                (hidden == 1 ? " hidden one" : " hidden ones");
    return text;
}

Grid grid(const Fonts &fonts, const Keyhole &keyhole) {
    const float em = fonts.size;
    Grid g;
    g.n = std::min(keyhole.emitters.size(), std::clamp<std::size_t>(n_visible(keyhole), 1, most_keyhole_pictures));
    g.columns = g.n > 1 ? 2 : 1;
    g.rows = std::max(1, static_cast<int>(g.n + 1) / 2);
    g.side = (g.n > 1 ? 9.5f : 15) * em;
    g.caption = g.n == 0 ? 0 : 2.9f * em;
    g.head = 1.7f * em;
    g.foot = others(keyhole, g.n).empty() ? 0 : 1.5f * em;
    g.pad = 0.6f * em;
    return g;
}

/// From a picture to the screen.
struct Mapping {
    Vec2 low, high;
    ImVec2 corner;
    float side;
    ImVec2 operator()(const Vec2 &p) const {
        const Vec2 part = (p - low).cwiseQuotient(high - low);
        return {corner.x + side * static_cast<float>(part.x()), corner.y + side * static_cast<float>(1 - part.y())};
    }
};

/// Without smoothed borders: these would show as seams where parts of one figure meet.
void fill(ImDrawList &list, const Mapping &at, const std::vector<Polygon> &parts, ImU32 colour) {
    const ImDrawListFlags flags = list.Flags;
    list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
    std::vector<ImVec2> points;
    for (const Polygon &part : parts) {
        points.clear();
        for (const Vec2 &p : part)
            points.push_back(at(p));
        list.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), colour);
    }
    list.Flags = flags;
}

/// Smooth borders after all, and no seams: lines of the same colour about every part.
void soften(ImDrawList &list, const Mapping &at, const std::vector<Polygon> &parts, ImU32 colour) {
    for (const Polygon &part : parts)
        for (std::size_t i = 0; i < part.size(); ++i)
            list.AddLine(at(part[i]), at(part[(i + 1) % part.size()]), colour, 1);
}

void stroke(ImDrawList &list, const Mapping &at, const KeyholeFigure &figure, ImU32 colour, float width) {
    for (const auto &[a, b] : figure.edges)
        list.AddLine(at(a), at(b), colour, width);
}

void stroke_dashed(ImDrawList &list, const Mapping &at, const KeyholeFigure &figure, ImU32 colour, float period) {
    for (const auto &[a, b] : figure.edges) {
        const ImVec2 from = at(a), to = at(b);
        const float dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
        const auto along = [&](float s) { return ImVec2(from.x + dx * s / length, from.y + dy * s / length); };
        for (float s = 0; s < length; s += period)
            list.AddLine(along(s), along(std::min(length, s + 0.55f * period)), colour, 1);
    }
}

void draw_picture(ImDrawList &list, const Fonts &fonts, ImVec2 corner, float side, const KeyholeEmitter &emitter) {
    const float em = fonts.size;
    const Mapping at{emitter.low, emitter.high, corner, side};
    const ImVec2 end{corner.x + side, corner.y + side};
    list.PushClipRect(corner, end, true);
    list.AddRectFilled(corner, end, night);
    for (const KeyholeFigure &blocker : emitter.blockers) {
        fill(list, at, blocker.parts, silhouette);
        stroke(list, at, blocker, silhouette_edge, 1);
    }
    stroke_dashed(list, at, emitter.whole, hidden_edge, 0.5f * em);
    fill(list, at, emitter.visible, lit);
    soften(list, at, emitter.visible, lit);
    for (const KeyholeCorner &c : emitter.corners) {
        list.AddCircleFilled(at(c.at), 0.27f * em, dot_rim);
        list.AddCircleFilled(at(c.at), 0.19f * em, dot);
    }
    list.PopClipRect();
    list.AddRect(corner, end, IM_COL32(128, 136, 150, 160));
}

std::string number(const char *format, double x) {
    char text[64];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// A text that is too wide is written smaller.
void write(ImDrawList &list, const Fonts &fonts, ImVec2 at, float width, ImU32 colour, const std::string &text) {
    const float needed = fonts.text->CalcTextSizeA(fonts.size, 1e9f, 0, text.c_str()).x;
    list.AddText(fonts.text, fonts.size * std::min(1.f, width / needed), at, colour, text.c_str());
}

std::string share_words(double share) {
    if (share <= 0)
        return "hidden";
    if (share >= 1)
        return "all visible";
    const double percent = 100 * share;
    return number(percent < 0.995 || percent > 99.05 ? "%.2g" : "%.3g", percent > 99.94 ? 99.9 : percent) +
           " % visible";
}

std::string irradiance_words(const Rgb &irradiance) {
    const bool small = irradiance.maxCoeff() > 0 && irradiance.maxCoeff() < 0.0095;
    const Rgb e = small ? Rgb(1e3 * irradiance) : irradiance;
    const std::string red = number("%.3g", e[0]), green = number("%.3g", e[1]), blue = number("%.3g", e[2]);
    return (red == green && green == blue ? red : red + " " + green + " " + blue) +
           (small ? " mW/m\u00b2" : " W/m\u00b2");
}

} // namespace

ImVec2 keyhole_inset_size(const Fonts &fonts, const Keyhole &keyhole) {
    const Grid g = grid(fonts, keyhole);
    const float pictures = static_cast<float>(g.rows) * (g.side + g.caption);
    return {static_cast<float>(g.columns) * g.side + static_cast<float>(g.columns + 1) * g.pad,
            g.pad + g.head + (g.n == 0 ? 1.6f * fonts.size : pictures) + g.foot};
}

void draw_keyhole_inset(ImDrawList &list, const Fonts &fonts, ImVec2 corner, const Keyhole &keyhole,
                        const Snapshot &snapshot, Theme theme) {
    const Grid g = grid(fonts, keyhole);
    const float em = fonts.size;
    const ImVec2 size = keyhole_inset_size(fonts, keyhole);
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y},
                       theme == Theme::dark ? IM_COL32(30, 34, 41, 245) : IM_COL32(246, 246, 246, 250), 0.3f * em);
    list.AddText(fonts.bold, em, {corner.x + g.pad, corner.y + g.pad}, ink(theme),
                 ("Seen from the point on " + surface_name(snapshot, keyhole.surface.index)).c_str());
    const float top = corner.y + g.pad + g.head;
    if (g.n == 0)
        list.AddText(fonts.text, em, {corner.x + g.pad, top}, ink(theme, 190), "No emitter is before it.");
    for (std::size_t i = 0; i < g.n; ++i) {
        const KeyholeEmitter &emitter = keyhole.emitters[i];
        const auto column = static_cast<float>(i % static_cast<std::size_t>(g.columns));
        const auto row = static_cast<float>(i / static_cast<std::size_t>(g.columns));
        const ImVec2 at{corner.x + g.pad + column * (g.side + g.pad), top + row * (g.side + g.caption)};
        draw_picture(list, fonts, at, g.side, emitter);
        const std::string first = surface_name(snapshot, emitter.whole.surface) + ": " + share_words(emitter.share);
        write(list, fonts, {at.x, at.y + g.side + 0.2f * em}, g.side, ink(theme), first);
        write(list, fonts, {at.x, at.y + g.side + 1.4f * em}, g.side, ink(theme, 190),
              (emitter.irradiance.isConstant(emitter.irradiance[0]) ? "irradiance " : "") +
                  irradiance_words(emitter.irradiance));
    }
    if (g.foot > 0)
        list.AddText(fonts.text, em, {corner.x + g.pad, corner.y + size.y - 1.4f * em}, ink(theme, 190),
                     others(keyhole, g.n).c_str());
}

void draw_keyhole_point(ImDrawList &list, const Fonts &fonts, ImVec2 low, ImVec2 high, const Camera &camera,
                        const Keyhole &keyhole) {
    const float width = high.x - low.x, height = high.y - low.y, em = fonts.size;
    const auto on_screen = [&](const Vec3 &p) -> std::optional<ImVec2> {
        const auto at = place_in_frame(camera, static_cast<double>(width / height), {p.x(), p.y(), p.z()});
        if (!at)
            return std::nullopt;
        return ImVec2(low.x + width * static_cast<float>(0.5 + 0.5 * at->x),
                      low.y + height * static_cast<float>(0.5 - 0.5 * at->y));
    };
    const auto here = on_screen(keyhole.point);
    if (!here)
        return;
    list.PushClipRect(low, high, true);
    for (std::size_t i = 0; i < std::min(most_keyhole_pictures, keyhole.emitters.size()); ++i)
        for (const KeyholeCorner &corner : keyhole.emitters[i].corners)
            if (const auto there = on_screen(corner.on_emitter)) {
                list.AddLine(*here, *there, IM_COL32(255, 225, 150, 120), 1.2f);
                list.AddCircleFilled(*there, 0.17f * em, dot);
            }
    list.AddCircle(*here, 0.42f * em, IM_COL32(10, 12, 16, 255), 0, 0.28f * em);
    list.AddCircle(*here, 0.42f * em, IM_COL32(255, 255, 255, 255), 0, 0.13f * em);
    list.AddCircleFilled(*here, 0.13f * em, dot);
    list.PopClipRect();
}

} // namespace penumbra
