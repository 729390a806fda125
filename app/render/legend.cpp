#include "render/labels.h"

#include "render/curve_pass.h"
#include "render/error_scale.h"
#include "render/mesh_pass.h"
#include "render/tone.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <set>

namespace penumbra {
namespace {

ImU32 ink(const Look &look) {
    return ImGui::ColorConvertFloat4ToU32(look.theme == Theme::dark ? ImVec4(0.93f, 0.94f, 0.96f, 1)
                                                                    : ImVec4(0.07f, 0.08f, 0.1f, 1));
}
ImVec4 to_imgui(const glm::vec4 &c) { return {c.r, c.g, c.b, c.a}; }

ImVec2 size_of(const Fonts &fonts, float size, const std::string &text) {
    return fonts.text->CalcTextSizeA(size, 1e9f, 0, text.c_str());
}

struct Ticks {
    std::vector<double> values;
    double step = 1;
};

/// Values at 1, 2 or 5 times a power of ten apart, about n of them.
Ticks ticks(const Range &range, double n) {
    const double span = range.high - range.low;
    Ticks result;
    if (!(span > 0) || !std::isfinite(span))
        return result;
    const double power = std::pow(10.0, std::floor(std::log10(span / n)));
    const double ratio = span / n / power, step = power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
    for (double k = std::ceil(range.low / step - 1e-9); k * step <= range.high + 1e-9 * span; ++k)
        result.values.push_back(k * step);
    result.step = step;
    return result;
}

/// With as many decimals as tell ticks apart that lie `step` from each other.
std::string tick_text(double value, double step) {
    char text[32];
    if (step < 1e-5 || std::abs(value) >= 1e6) {
        std::snprintf(text, sizeof text, "%.3g", value);
        return text;
    }
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
    std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < 1e-9 * step ? 0.0 : value);
    return text;
}

/// What a colour bar is drawn from.
struct Scale {
    std::string heading;
    std::vector<std::pair<double, std::string>> ticks; ///< place on the bar in [0, 1], and text
    std::function<glm::dvec3(double)> colour;          ///< at a place
};

Scale radiosity_scale(const Look &look, const Range &range, double n) {
    Scale scale;
    scale.heading = look.false_colour ? "radiosity, mean of R, G, B [W/m\u00b2]" : "radiosity [W/m\u00b2]";
    if (look.exposure_ev != 0) {
        char exposure[32];
        std::snprintf(exposure, sizeof exposure, ", exposure %+.3g EV", look.exposure_ev);
        scale.heading += exposure;
    }
    const Ticks marks = ticks(range, n);
    for (const double v : marks.values)
        scale.ticks.emplace_back((v - range.low) / (range.high - range.low), tick_text(v, marks.step));
    scale.colour = [=](double t) { return shown(look, range, range.low + t * (range.high - range.low)); };
    return scale;
}

/// A share in percent, or a plain ratio.
std::string power_text(ErrorKind kind, double value) {
    char text[32];
    std::snprintf(text, sizeof text, kind == ErrorKind::estimate ? "%.6g" : "%.6g %%",
                  kind == ErrorKind::estimate ? value : 100 * value);
    return text;
}

Scale error_scale(const Look &look, const Range &range, double n) {
    const ErrorKind kind = look.error;
    Scale scale;
    scale.heading = error_heading(look);
    const auto add = [&](double v, const std::string &text) { scale.ticks.emplace_back(place(kind, range, v), text); };
    if (is_logarithmic(kind)) {
        const int first = static_cast<int>(std::ceil(std::log10(range.low) - 1e-6)),
                  last = static_cast<int>(std::floor(std::log10(range.high) + 1e-6));
        const int every = std::max(1, static_cast<int>(std::ceil((last - first) / n)));
        for (int k = first; k <= last; ++k)
            if (kind == ErrorKind::estimate ? k % every == 0 : (last - k) % every == 0)
                add(std::pow(10, k), power_text(kind, std::pow(10, k)));
    } else {
        const Ticks marks = ticks(range, n);
        for (const double v : marks.values)
            add(v, (v > 0 ? "+" : v < 0 ? "\u2212" : "") + tick_text(std::abs(v), marks.step));
    }
    scale.colour = [=](double t) {
        const double value = is_logarithmic(kind) ? range.low * std::pow(range.high / range.low, t)
                                                  : range.low + t * (range.high - range.low);
        return error_colour(kind, range, value);
    };
    return scale;
}

/// With about n ticks.
Scale scale_of(const Look &look, const Range &range, double n) {
    if (look.shading == Shading::error && look.error_range)
        return error_scale(look, *look.error_range, n);
    return radiosity_scale(look, range, n);
}

/// The bar in thin strips; `strip(i, n)` is the rectangle of the i-th of n from the low end.
void draw_bar(ImDrawList &list, const Scale &scale, const std::function<std::pair<ImVec2, ImVec2>(int, int)> &strip) {
    constexpr int n = 128;
    for (int i = 0; i < n; ++i) {
        const auto [low, high] = strip(i, n);
        list.AddRectFilled(low, high,
                           ImGui::ColorConvertFloat4ToU32(to_imgui(glm::vec4(scale.colour((i + 0.5) / n), 1))));
    }
}

} // namespace

ImVec4 shown_colour(const Look &look, const Range &range, double radiosity) {
    return to_imgui(glm::vec4(shown(look, range, radiosity), 1));
}

ImVec4 curve_colour(int kind) { return to_imgui(curve_rgba(kind)); }

ImVec2 draw_colour_legend(ImDrawList &list, const Fonts &fonts, ImVec2 corner, float bar_height, const Look &look,
                          const Range &range) {
    const float em = fonts.size, bar = 0.9f * em, gap = 0.35f * em;
    float text_width = 0;
    const Scale scale = scale_of(look, range, static_cast<double>(std::clamp(bar_height / (2.2f * em), 2.f, 6.f)));
    for (const auto &[at, text] : scale.ticks)
        text_width = std::max(text_width, size_of(fonts, em, text).x);
    const float head = size_of(fonts, em, scale.heading).x, width = std::max(bar + 2 * gap + text_width, head);
    const float top = corner.y + 1.7f * em, right = corner.x - text_width - 2 * gap, left = right - bar;
    const glm::vec4 background = background_colour(look.theme);
    const auto ground = [&](ImVec2 low, ImVec2 high) {
        list.AddRectFilled({low.x - gap, low.y - gap}, {high.x + gap, high.y + gap},
                           ImGui::ColorConvertFloat4ToU32({background.r, background.g, background.b, 0.7f}), gap);
    };
    ground({corner.x - head, corner.y}, {corner.x, corner.y + em});
    ground({left, top}, {corner.x, top + bar_height + gap});
    list.AddText(fonts.text, em, {corner.x - head, corner.y}, ink(look), scale.heading.c_str());
    draw_bar(list, scale, [&](int i, int n) {
        const auto y = [&](int k) { return top + bar_height * (1 - static_cast<float>(k) / static_cast<float>(n)); };
        return std::pair(ImVec2(left, y(i + 1)), ImVec2(right, y(i)));
    });
    list.AddRect({left, top}, {right, top + bar_height}, ink(look));
    for (const auto &[at, text] : scale.ticks) {
        const float y = top + bar_height * static_cast<float>(1 - at);
        list.AddLine({right, y}, {right + gap, y}, ink(look));
        list.AddText(fonts.text, em, {right + 2 * gap, y - 0.5f * em}, ink(look), text.c_str());
    }
    return {width, bar_height + 2.3f * em};
}

ImVec2 draw_colour_legend_lying(ImDrawList &list, const Fonts &fonts, ImVec2 corner, float width, const Look &look,
                                const Range &range) {
    const float em = fonts.size, bar = 0.8f * em;
    const Scale scale = scale_of(look, range, static_cast<double>(std::clamp(width / (5 * em), 2.f, 6.f)));
    list.AddText(fonts.text, em, corner, ink(look), scale.heading.c_str());
    const float top = corner.y + 1.35f * em, left = corner.x;
    draw_bar(list, scale, [&](int i, int n) {
        const auto x = [&](int k) { return left + width * static_cast<float>(k) / static_cast<float>(n); };
        return std::pair(ImVec2(x(i), top), ImVec2(x(i + 1), top + bar));
    });
    list.AddRect({left, top}, {left + width, top + bar}, ink(look));
    float free_from = left; // where the text before ends: at the bar's ends texts are moved inward
    for (const auto &[at, text] : scale.ticks) {
        const float x = left + width * static_cast<float>(at);
        const float text_width = size_of(fonts, em, text).x;
        list.AddLine({x, top + bar}, {x, top + bar + 0.25f * em}, ink(look));
        const float text_left = std::clamp(x - text_width / 2, left, std::max(left, left + width - text_width));
        if (text_left < free_from)
            continue;
        list.AddText(fonts.text, em, {text_left, top + bar + 0.3f * em}, ink(look), text.c_str());
        free_from = text_left + text_width + 0.4f * em;
    }
    return {width, 1.35f * em + bar + 1.4f * em};
}

namespace {

struct LegendEntry {
    ImVec4 colour;
    float width = 1, dash = 0, drawn = 1; ///< of the line; width 0: text alone
    std::string text;
};

/// "12 of 60 curves are hidden"; empty when the filter lets all pass. Panes that are compared have the same curves.
std::string hidden_curves(const Look &look, const std::vector<const Snapshot *> &snapshots) {
    if (snapshots.empty() || !snapshots.front()->curves)
        return {};
    const auto &curves = *snapshots.front()->curves;
    const auto hidden =
        std::ranges::count_if(curves, [&](const SnapshotCurve &c) { return !look.curve_filter.shows(c); });
    return hidden == 0 ? "" : std::to_string(hidden) + " of " + std::to_string(curves.size()) + " curves are hidden";
}

std::vector<LegendEntry> line_entries(const Look &look, const std::vector<const Snapshot *> &snapshots) {
    static const char *const kinds[] = {"VE: a corner behind an edge", "EV: a corner before an edge",
                                        "EEE: three edges meet", "plane seen edge-on", "contact"};
    std::vector<LegendEntry> entries;
    bool uniform = false, cut = false, fresh = false, blocker = false;
    std::set<std::pair<int, int>> curves;
    for (const Snapshot *s : snapshots) {
        for (const SnapshotPatch &p : s->patches)
            if (role(s->surfaces[static_cast<std::size_t>(p.surface)]) == SurfaceRole::reflector) // no mesh on lamps
                for (const SideKind kind : p.sides) {
                    uniform |= kind == SideKind::uniform;
                    cut |= kind == SideKind::cut;
                    fresh |= p.fresh && kind == SideKind::uniform && s->n_shown_events <= 0;
                }
        for (const SnapshotSurface &surface : s->surfaces)
            blocker |= role(surface) == SurfaceRole::blocker;
        if (s->curves)
            for (const SnapshotCurve &c : *s->curves)
                if (look.curve_filter.shows(c))
                    curves.emplace(c.kind, c.order);
    }
    const auto add_mesh = [&](SideKind kind, bool is_fresh, const char *text) {
        entries.push_back({to_imgui(mesh_colour(kind, is_fresh)), mesh_width(kind, is_fresh), 0, 1, text});
    };
    if (look.layers.mesh) {
        if (uniform)
            add_mesh(SideKind::uniform, false, "uniform split");
        if (fresh && look.emphasise_fresh)
            add_mesh(SideKind::uniform, true, "new in this step");
        if (cut)
            add_mesh(SideKind::cut, false, "cut along a curve");
    }
    if (std::ranges::any_of(snapshots, [](const Snapshot *s) { return s->n_shown_events > 0; }))
        entries.push_back({to_imgui(newest_event_colour()), newest_event_width(), 0, 1, "this split"});
    if (std::ranges::any_of(snapshots, [](const Snapshot *s) { return s->n_shown_linkings > 0; }))
        entries.push_back({to_imgui(newest_event_colour()), newest_event_width(), 0, 1, "this link"});
    if (look.layers.curves)
        for (const auto &[kind, order] : curves) {
            const CurveStroke stroke = curve_stroke(order);
            const std::string jump = order == 0 ? " (value jumps)" : order == 1 ? " (slope jumps)" : "";
            entries.push_back({curve_colour(kind), stroke.width, stroke.dash, stroke.drawn, kinds[std::clamp(kind, 0, 4)] + jump});
        }
    if (const std::string hidden = hidden_curves(look, snapshots); look.layers.curves && !hidden.empty())
        entries.push_back({{}, 0, 0, 1, hidden});
    if (blocker)
        entries.push_back({to_imgui(outline_colour(SurfaceRole::blocker, look.theme)), outline_width(SurfaceRole::blocker), 0, 1,
                           "blocker, seen through"});
    return entries;
}

/// Places the entries; draws them when there is a list.
ImVec2 flow(ImDrawList *list, const Fonts &fonts, ImVec2 corner, float width, const Look &look,
            const std::vector<LegendEntry> &entries) {
    const float em = fonts.size, swatch = 2.2f * em, gap = 0.45f * em, between = 1.5f * em, line = 1.45f * em;
    const float scale = em / 15;
    float x = 0, y = 0, widest = 0;
    for (const LegendEntry &e : entries) {
        const float text_width = size_of(fonts, em, e.text).x, before = e.width > 0 ? swatch + gap : 0;
        const float all = before + text_width;
        if (x > 0 && x + all > width) {
            x = 0;
            y += line;
        }
        if (list != nullptr && e.width <= 0)
            list->AddText(fonts.text, em, {corner.x + x, corner.y + y}, ink(look), e.text.c_str());
        else if (list != nullptr) {
            // On the grey of a lit floor, where lines look as they do in the picture.
            const ImVec2 low(corner.x + x, corner.y + y), high(low.x + swatch, low.y + em);
            list->AddRectFilled(low, high, IM_COL32(178, 178, 178, 255), 0.15f * em);
            const float middle = low.y + 0.5f * em, period = e.dash > 0 ? e.dash * scale : swatch;
            for (float start = low.x; start < high.x - 0.5f; start += period)
                list->AddLine({start, middle}, {std::min(high.x, start + period * (e.dash > 0 ? e.drawn : 1)), middle},
                              ImGui::ColorConvertFloat4ToU32(e.colour), e.width * scale);
            list->AddText(fonts.text, em, {high.x + gap, low.y}, ink(look), e.text.c_str());
        }
        widest = std::max(widest, x + all);
        x += all + between;
    }
    return entries.empty() ? ImVec2(0, 0) : ImVec2(widest, y + line);
}

} // namespace

ImVec2 draw_line_legend(ImDrawList &list, const Fonts &fonts, ImVec2 corner, float width, const Look &look,
                        const std::vector<const Snapshot *> &snapshots) {
    return flow(&list, fonts, corner, width, look, line_entries(look, snapshots));
}

ImVec2 line_legend_size(const Fonts &fonts, float width, const Look &look,
                        const std::vector<const Snapshot *> &snapshots) {
    return flow(nullptr, fonts, {0, 0}, width, look, line_entries(look, snapshots));
}

} // namespace penumbra
