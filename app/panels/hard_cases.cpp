// The shelf of hard cases: what each asks for, whether it holds, and its scene.
#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "shelf_verbs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace penumbra {

namespace {

/// How far a measurement misses its bound: value over bound; without end where nothing but 0 was allowed.
double excess(const Measurement &m) {
    return m.bound > 0 && std::isfinite(m.value) ? m.value / m.bound : std::numeric_limits<double>::infinity();
}

/// "1.4×": of the measurement that misses its bound most; its value where the bound is 0.
std::string figure_of(const CaseVerdict &v) {
    const Measurement *worst = nullptr;
    for (const Measurement &m : v.measurements)
        if (!m.holds() && (!worst || excess(m) > excess(*worst)))
            worst = &m;
    if (!worst)
        return "";
    return std::isfinite(excess(*worst)) ? power_words(excess(*worst)) + "\u00d7" : power_words(worst->value, 2);
}

std::string badge_words(const CaseVerdict &v) {
    switch (v.status) {
    case CaseStatus::not_run:
        return "not run";
    case CaseStatus::running:
        return "running\u2026";
    case CaseStatus::ok:
        return "ok";
    case CaseStatus::failed:
        return v.measurements.empty() ? "failed" : "failed " + figure_of(v);
    }
    return "";
}

/// Okabe & Ito's green and vermilion (2008), told apart by colour-blind people; the words say the same.
ImVec4 badge_colour(CaseStatus status) {
    switch (status) {
    case CaseStatus::ok:
        return {0.00f, 0.45f, 0.33f, 1};
    case CaseStatus::failed:
        return {0.70f, 0.28f, 0.00f, 1};
    case CaseStatus::running:
        return {0.00f, 0.35f, 0.55f, 1};
    case CaseStatus::not_run:
        break;
    }
    return {0, 0, 0, 0};
}

void tell_verdict(const ShelfCase &c, const CaseVerdict &v, const char *basis) {
    note_told(badge_words(v), c.what + ".");
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(em(30));
    ImGui::TextUnformatted((c.what + ".").c_str());
    if (!v.trouble.empty())
        ImGui::TextUnformatted(v.trouble.c_str());
    ImGui::PopTextWrapPos();
    if (!v.measurements.empty() && ImGui::BeginTable("measurements", 4, ImGuiTableFlags_SizingFixedFit)) {
        for (const char *head : {"quantity", "measured", "at most", ""}) {
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", head);
        }
        for (const Measurement &m : v.measurements) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(m.quantity.c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(power_words(m.value).c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(power_words(m.bound).c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(m.holds() ? "ok" : "failed");
        }
        ImGui::EndTable();
        ImGui::TextDisabled("%s basis, in %s", basis, seconds_words(v.seconds).c_str());
    }
    ImGui::TextDisabled("A click opens its scene in the %s basis.", basis);
    ImGui::EndTooltip();
}

/// On as many lines as it takes, broken after hyphens.
std::string in_lines(const std::string &name, float width) {
    std::string text;
    std::size_t line = 0; // where it begins
    for (std::size_t from = 0; from < name.size();) {
        const std::size_t to = std::min(name.find('-', from), name.size() - 1) + 1;
        const std::string part = name.substr(from, to - from);
        if (text.size() > line && ImGui::CalcTextSize((text.substr(line) + part).c_str()).x > width) {
            text += '\n';
            line = text.size();
        }
        text += part;
        from = to;
    }
    return text;
}

/// The request goes out after the row: opening changes what the panels stand on.
struct Click {
    std::size_t index;
    std::optional<BasisFamily> basis;
};

void draw_badge(AppState &state, const ShelfCase &c, std::size_t index, BasisFamily basis,
                std::optional<Click> &click) {
    const CaseVerdict &v = c.verdicts[static_cast<std::size_t>(basis)];
    const std::string basis_name(name(basis)), id = "case " + c.name + " " + basis_name;
    const bool ran = v.status != CaseStatus::not_run;
    for (const ImGuiCol part : {ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive})
        ImGui::PushStyleColor(part, badge_colour(v.status));
    ImGui::PushStyleColor(ImGuiCol_Text, ran ? ImVec4(1, 1, 1, 1) : ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    if (ImGui::SmallButton((badge_words(v) + "##" + id).c_str()))
        click = Click{index, basis};
    ImGui::PopStyleColor(4);
    mark(state, id);
    if (ImGui::IsItemHovered())
        tell_verdict(c, v, basis_name.c_str());
}

void draw_head(AppState &state) {
    const Shelf &shelf = state.shelf;
    const int ok = n_verdicts(shelf, CaseStatus::ok), failed = n_verdicts(shelf, CaseStatus::failed);
    const int all = 2 * static_cast<int>(shelf.cases.size());
    action_button(state, shelf.checking ? "check.stop" : "check.all", shelf.checking ? "Stop" : "Check all",
                  {em(6), 0});
    ImGui::SameLine();
    const std::string progress = std::to_string(ok + failed) + " of " + std::to_string(all);
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_Header));
    ImGui::ProgressBar(static_cast<float>(ok + failed) / static_cast<float>(std::max(1, all)), {-1, 0},
                       ok + failed > 0 || shelf.checking ? progress.c_str() : "");
    ImGui::PopStyleColor();
    mark(state, "check progress");
    tooltip("Checked", "Cases that were solved and measured, in both bases.");
    ImGui::PushTextWrapPos(0);
    if (ok + failed == 0)
        ImGui::TextDisabled(
            "Small scenes in which solvers lose digits. Each is solved in both bases, and what must hold "
            "is measured. A click opens one.");
    else
        ImGui::TextDisabled("%d hold, %d miss a bound: by how much stands beside it. Rest the mouse on one to see what "
                            "was measured.",
                            ok, failed);
    ImGui::PopTextWrapPos();
}

} // namespace

void draw_hard_cases(AppState &state) {
    fill_shelf(state);
    draw_head(state);
    std::optional<Click> click;
    if (!ImGui::BeginTable("cases", 3, ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit))
        return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("case", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("parametric", ImGuiTableColumnFlags_WidthFixed, em(6.2f));
    ImGui::TableSetupColumn("planar", ImGuiTableColumnFlags_WidthFixed, em(6.2f));
    for (const char *head : {"case", "parametric", "planar"}) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", head);
    }
    for (std::size_t i = 0; i < state.shelf.cases.size(); ++i) {
        const ShelfCase &c = state.shelf.cases[i];
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        if (ImGui::Selectable((in_lines(c.name, ImGui::GetContentRegionAvail().x) + "##" + c.name).c_str(),
                              state.scene && state.scene->name == c.name))
            click = Click{i, std::nullopt};
        mark(state, "case " + c.name);
        tooltip(c.name, c.what + ". A click opens its scene.");
        for (const BasisFamily basis : {BasisFamily::parametric, BasisFamily::planar}) {
            ImGui::TableNextColumn();
            draw_badge(state, c, i, basis, click);
        }
    }
    ImGui::EndTable();
    if (click)
        open_case(state, click->index, click->basis);
}

} // namespace penumbra
