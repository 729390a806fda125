#include "render/labels.h"

#include "core/percent.h"
#include "embedded.h"
#include "iteration/error_map.h"

#include <algorithm>
#include <cstdio>

namespace penumbra {
namespace {

ImU32 ink(Theme theme, float opacity = 1) {
    return ImGui::ColorConvertFloat4ToU32(theme == Theme::dark ? ImVec4(0.93f, 0.94f, 0.96f, opacity)
                                                               : ImVec4(0.07f, 0.08f, 0.1f, opacity));
}

float width_of(const ImFont *font, float size, const std::string &text) {
    return font->CalcTextSizeA(size, 1e9f, 0, text.c_str()).x;
}

/// The figures joined with middle dots, as many on a line as fit; then the time, which has the same room whatever it is,
/// so that a picture that is made again is laid out as it was.
std::vector<std::string> in_lines(const Fonts &fonts, float width, const PaneLabel &label) {
    std::vector<std::string> lines;
    const auto add = [&](const std::string &item, const std::string &room) {
        const std::string dot = "  \u00b7  ";
        if (!lines.empty() && width_of(fonts.text, fonts.size, lines.back() + dot + room) <= width)
            lines.back() += dot + item;
        else
            lines.push_back(item);
    };
    for (const std::string &item : label.figures)
        add(item, item);
    if (!label.time.empty())
        add(label.time, "0.00000 ms");
    return lines;
}

std::string counted(std::int64_t n, const char *one, const char *many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
}

std::string formatted(const char *format, double x) {
    char text[64];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

/// Three significant digits.
std::string three_digits(double x) {
    return formatted(x >= 100 ? "%.0f" : x >= 10 ? "%.1f" : x >= 1 ? "%.2f" : "%.3g", x);
}

constexpr float line_height = 1.28f; // of the text height
constexpr float padding = 0.6f;

constexpr float footnote_size = 0.9f;

constexpr float largest_letters = 96; ///< pixels; of more the letters' texture would be larger than drivers take

} // namespace

Fonts load_fonts(float size) {
    // Latin, Greek, punctuation, super- and subscripts, arrows, mathematical signs.
    static const ImWchar ranges[] = {0x0020, 0x017f, 0x0370, 0x03ff, 0x2000, 0x209f, 0x2190, 0x21ff,
                                     0x1d40, 0x1d40, 0x2200, 0x22ff, 0x23e9, 0x23fa, 0x25a0, 0x25ff, 0};
    const float drawn = std::min(size, largest_letters);
    const auto load = [&](const char *path) {
        const std::string_view bytes = embedded(path);
        ImFontConfig config;
        config.FontDataOwnedByAtlas = false; // it stays in the program; the atlas only reads it
        config.OversampleH = size > 24 ? 1 : 2;
        config.OversampleV = 1;
        return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<char *>(bytes.data()),
                                                          static_cast<int>(bytes.size()), drawn, &config, ranges);
    };
    Fonts fonts;
    fonts.size = size;
    fonts.text = load("assets/fonts/DejaVuSans.ttf");
    fonts.bold = load("assets/fonts/DejaVuSans-Bold.ttf");
    return fonts;
}

namespace {

std::string solution_title(const Snapshot &snapshot) {
    std::string text(title(snapshot.options.strategy));
    if (!is_constant(snapshot.options.strategy))
        text += ", M = " + std::to_string(snapshot.options.order);
    if (snapshot.reconstructed)
        text += ", as quadratics (1993)";
    if (snapshot.options.basis == BasisFamily::planar)
        text += ", on polygons";
    return text;
}

} // namespace

PaneLabel difference_label(const Snapshot &first, const Snapshot &second, const ErrorMap *map) {
    const auto tag = [](const Snapshot &s) {
        return std::string("(") + "abcd"[static_cast<std::size_t>(s.options.strategy)] + ")";
    };
    PaneLabel label = pane_label(second);
    label.title = "Difference: " + tag(second) + " minus " + tag(first);
    label.figures = {tag(second) + " " + solution_title(second), tag(first) + " " + solution_title(first)};
    if (map)
        label.figures.push_back("they differ by " + three_digits(100 * map->error()) + " %");
    label.time.clear();
    return label;
}

PaneLabel pane_label(const Snapshot &snapshot, const std::string &tag, const ErrorMap *errors) {
    const Counters &c = snapshot.counters;
    PaneLabel label;
    label.title = (tag.empty() ? "" : tag + " ") + solution_title(snapshot);
    label.figures = {counted(c.patches, "patch", "patches"), counted(c.coefficients, "coefficient", "coefficients")};
    const double error = errors ? errors->error() : snapshot.error;
    if (errors && errors->change)
        label.figures.push_back("changed by " + three_digits(100 * error) + " % with " + words(*errors->change));
    else if (error >= 0)
        label.figures.push_back("error " + three_digits(100 * error) + " %");
    else if (c.estimated_error >= 0)
        label.figures.push_back("error about " + percent(c.estimated_error));
    if (errors && errors->truth_error > 0)
        label.figures.push_back("reference good to " + three_digits(100 * errors->truth_error) + " %");
    if (c.iteration > 0 || c.seconds > 0)
        label.time = c.seconds < 0.1 ? three_digits(1000 * c.seconds) + " ms" : three_digits(c.seconds) + " s";
    label.footnote = snapshot.scene + ", ";
    if (c.iteration == 0)
        label.footnote += "before the first step";
    else if (c.converged)
        label.footnote += "converged in " + counted(c.iteration, "step", "steps");
    else
        label.footnote += "step " + std::to_string(c.iteration) + ", after " +
                          (snapshot.n_shown_events > 0
                               ? "split " + std::to_string(snapshot.n_shown_events) + " of " + std::to_string(snapshot.events->size())
                           : snapshot.n_shown_linkings > 0
                               ? "link " + std::to_string(snapshot.n_shown_linkings) + " of " + std::to_string(snapshot.linkings->size())
                               : std::string(name(snapshot.phase)));
    return label;
}

float pane_label_height(const Fonts &fonts, float width, const PaneLabel &label) {
    const auto n = in_lines(fonts, width - 2 * padding * fonts.size, label).size();
    return fonts.size * (padding + line_height * static_cast<float>(n + 1) + 0.2f);
}

float draw_pane_label(ImDrawList &list, const Fonts &fonts, ImVec2 low, ImVec2 high, const PaneLabel &label, Theme theme,
                      bool grounded) {
    const float em = fonts.size, width = high.x - low.x - 2 * padding * em, x = low.x + padding * em;
    // A title that is too wide is drawn smaller rather than cut.
    const float title_size = em * std::min(1.f, width / std::max(1.f, width_of(fonts.bold, em, label.title)));
    float y = low.y + padding * em;
    const auto write = [&](const ImFont *font, float size, const std::string &line) {
        const glm::vec4 ground = background_colour(theme);
        const ImVec2 from{x - 0.25f * em, y - 0.1f * em}, to{x + width_of(font, size, line) + 0.25f * em, y + 1.2f * size};
        if (grounded && !line.empty())
            list.AddRectFilled(from, to, ImGui::ColorConvertFloat4ToU32({ground.r, ground.g, ground.b, 0.7f}), 0.25f * em);
        list.AddText(font, size, {x, y}, ink(theme), line.c_str());
    };
    list.PushClipRect(low, high, true);
    write(fonts.bold, title_size, label.title);
    for (const std::string &line : in_lines(fonts, width, label)) {
        y += line_height * em;
        write(fonts.text, em, line);
    }
    draw_footnote(list, fonts, {x, high.y - (padding + footnote_size) * em}, label, theme);
    list.PopClipRect();
    return pane_label_height(fonts, high.x - low.x, label);
}

void draw_footnote(ImDrawList &list, const Fonts &fonts, ImVec2 corner, const PaneLabel &label, Theme theme) {
    list.AddText(fonts.text, footnote_size * fonts.size, corner, ink(theme, 0.75f), label.footnote.c_str());
}

} // namespace penumbra
