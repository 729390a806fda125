// A picked element: what it holds, who lights it, how it came about; and the curve that was pinned.
#include "element_verbs.h"
#include "panels/coefficient_bars.h"
#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "render/event_words.h"
#include "render/labels.h"
#include "render/pick.h"

#include <string>

namespace penumbra {

namespace {

void paragraph(const std::string &text) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

void quiet_paragraph(const std::string &text) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::PopTextWrapPos();
}

void draw_pinned_curve(const AppState &state) {
    const auto snapshot = state.active_solution();
    if (!state.pinned_curve || !snapshot || !snapshot->curves ||
        *state.pinned_curve >= static_cast<int>(snapshot->curves->size()))
        return;
    const SnapshotCurve &curve = (*snapshot->curves)[static_cast<std::size_t>(*state.pinned_curve)];
    const EventWords words = event_words(*snapshot, curve);
    heading("The curve that was picked");
    ImGui::TextColored(curve_colour(curve.kind), "%s", words.symbol.c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s", words.way.c_str());
    paragraph(words.sentence + " " + words.jump);
}

void draw_what_it_holds(AppState &state, const ElementReport &r) {
    const auto snapshot = state.active_solution();
    const SnapshotSurface &surface = snapshot->surfaces[static_cast<std::size_t>(r.surface)];
    const int patch = patch_at(*snapshot, r.surface, to_plane(surface, r.question.point));
    const float side = em(6), gap = em(0.8f);
    if (patch >= 0) {
        ImGui::BeginGroup();
        draw_polynomial_map(*snapshot, patch, state.active_camera(), state.look, side);
        ImGui::EndGroup();
        tooltip("The element's radiosity [W/m\u00b2]", "Mean of the channels, from its least to its largest value here.");
        ImGui::SameLine(0, gap);
    }
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(0);
    const Rgb mean = r.coefficients.row(0).transpose().array();
    ImGui::TextUnformatted(("constant: " + rgb_words(mean) + " W/m\u00b2").c_str());
    const auto n = static_cast<int>(r.coefficients.rows());
    if (n > 1) {
        draw_coefficient_bars(r, ImGui::GetContentRegionAvail().x, side - 2 * ImGui::GetTextLineHeightWithSpacing());
        mark(state, "coefficients");
        const double most = r.coefficients.bottomRows(n - 1).cwiseAbs().maxCoeff();
        ImGui::TextDisabled("other %d functions, \u00b1%s W/m\u00b2", n - 1, number_words(most).c_str());
    } else {
        ImGui::TextDisabled("one function: a constant");
    }
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
}

void draw_history(const ElementReport &r) {
    heading("How it came about");
    for (const std::string &sentence : history_words(r))
        paragraph(sentence);
}

/// Why there is nothing to be seen.
void say_why_not(const AppState &state) {
    const bool answered = state.element.at && !awaits_report(state) && !state.halted;
    if (!state.element.at)
        paragraph("Click a patch in a pane: what it holds, who lights it and how it came about will stand here.");
    else if (answered)
        paragraph("To save memory the solver has let go of the links of this step. Go on to a later one (\u2192).");
    else
        quiet_paragraph(state.halted ? "The solver was stopped; click the patch again." : "looking at the element\u2026");
}

} // namespace

void draw_element(AppState &state, const Fonts &fonts) {
    draw_pinned_curve(state);
    const ElementReport *now = shown_report(state);
    if (!now) {
        say_why_not(state);
        return;
    }
    const auto kept = state.element.shown; // whatever the rows do
    heading(penumbra::heading(*kept).c_str());
    draw_what_it_holds(state, *kept);
    draw_element_links(state, *kept);
    draw_xray(state, fonts);
    draw_history(*kept);
}

} // namespace penumbra
