// Who lights the picked element: a row for each surface, a click on which draws and X-rays its links.
#include "core/percent.h"
#include "element_verbs.h"
#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "render/event_words.h"
#include "render/link_colour.h"

#include <algorithm>
#include <string>

namespace penumbra {

namespace {

constexpr std::size_t most_rows = 6;

ImU32 kind_colour(int kind) {
    const glm::vec3 c = link_colour(kind);
    return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
}

const char *short_verdict(LinkVerdict verdict) {
    switch (verdict) {
    case LinkVerdict::passes:
        return "passes";
    case LinkVerdict::weak:
        return "weak";
    case LinkVerdict::order_too_low:
    case LinkVerdict::source_too_coarse:
    case LinkVerdict::too_bright_for_weak:
        return "anew";
    case LinkVerdict::splits:
    case LinkVerdict::descends:
        return "fails";
    case LinkVerdict::at_limit:
        return "at limit";
    }
    return "";
}

std::string whose(const LinkReport &l) {
    const std::string n = std::to_string(l.n_links) + (l.n_links == 1 ? " link" : " links");
    const std::string to = l.levels_up == 0   ? "to the element itself"
                           : l.levels_up == 1 ? "to its parent, element " + std::to_string(l.receiver)
                                              : "to element " + std::to_string(l.receiver) + ", " +
                                                    std::to_string(l.levels_up) + " splits above";
    return n + " " + to + ", " + link_kind_words(l.kind) + "; fit of order " + std::to_string(l.order) +
           (l.order < l.full_order ? " of " + std::to_string(l.full_order) : "");
}

void tell_row(const std::string &source, const LinkReport &l, bool selected) {
    if (!ImGui::IsItemHovered() || selected) // then it stands below the rows
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(em(24));
    ImGui::TextUnformatted((source + " " + l.words + ".").c_str());
    ImGui::TextDisabled("%s.", whose(l).c_str());
    ImGui::TextDisabled("At the element's centre it brings %s W/m\u00b2.", rgb_words(l.at_centre).c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// With its number, where several that light the element have the same name.
std::string source_name(const Snapshot &snapshot, const ElementReport &report, int source) {
    const std::string own = surface_name(snapshot, source);
    const auto n = std::ranges::count_if(report.links, [&](const auto &l) { return surface_name(snapshot, l.source) == own; });
    return n > 1 ? own + " (" + std::to_string(source) + ")" : own;
}

/// "41 %", "20 times".
std::string misses_words(const LinkReport &l) {
    if (l.weak)
        return "\u2013";
    return l.share < 10 ? percent(l.share) : number_words(l.share) + " times";
}

void draw_row(AppState &state, const Snapshot &snapshot, const ElementReport &report, const LinkReport &l) {
    const std::string source = source_name(snapshot, report, l.source);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(l.source);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + 0.25f * em()}, {at.x + em(0.6f), at.y + 0.85f * em()},
                                              kind_colour(l.kind));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + em(0.9f));
    if (ImGui::Selectable(source.c_str(), state.element.source == l.source, ImGuiSelectableFlags_SpanAllColumns))
        pick_source(state, l.source);
    mark(state, "link from " + std::to_string(l.source));
    tell_row(source, l, state.element.source == l.source);
    ImGui::PopID();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(number_words(l.mean.mean()).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(misses_words(l).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(short_verdict(l.verdict));
}

void head(const char *name, const char *sentence) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    tooltip(name, sentence);
}

} // namespace

void draw_element_links(AppState &state, const ElementReport &report) {
    const auto snapshot = state.active_solution();
    heading("Who lights it");
    if (report.links.empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled(state.shown_position() == 0 ? "Nobody yet: links are made in the first step (\u2192)."
                                                        : "Nobody: no light comes to it.");
        ImGui::PopTextWrapPos();
        return;
    }
    // Where many do, their rows scroll, so that the X-ray stays in sight.
    const bool many = report.links.size() > most_rows;
    const float height = many ? (static_cast<float>(most_rows) + 1.5f) * ImGui::GetTextLineHeightWithSpacing() : 0;
    if (!ImGui::BeginTable("links", 4, ImGuiTableFlags_SizingStretchProp | (many ? ImGuiTableFlags_ScrollY : 0), {0, height}))
        return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("source", 0, 2.6f);
    ImGui::TableSetupColumn("brings", 0, 1.2f);
    ImGui::TableSetupColumn("misses", 0, 1.1f);
    ImGui::TableSetupColumn("verdict", 0, 1.2f);
    head("source", "The surface that the links come from; the colour is that of the links layer: blue clear, yellow near or "
                   "touching, purple partly hidden.");
    head("W/m\u00b2", "What its links bring to this element in the mean, reflected.");
    head("misses", "What the fit misses, as a share of what the oracle lets pass: above 100 % it fails.");
    head("oracle", "What becomes of it when it is judged next.");
    for (const LinkReport &l : report.links)
        draw_row(state, *snapshot, report, l);
    ImGui::EndTable();
    if (const LinkReport *l = picked_links(state)) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted((source_name(*snapshot, report, l->source) + " " + l->words + ".").c_str());
        ImGui::TextDisabled("%s.", whose(*l).c_str());
        ImGui::PopTextWrapPos();
    } else {
        ImGui::TextDisabled("Click a row: its links are drawn and X-rayed.");
    }
}

} // namespace penumbra
