#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "verbs.h"

#include <string>

namespace penumbra {

namespace {

void draw_layers(AppState &state) {
    heading("Show");
    action_check(state, "layers.mesh");
    ImGui::SameLine(em(7.5f));
    action_check(state, "layers.fresh", "New patches");
    action_check(state, "layers.curves", "Curves");
    ImGui::SameLine(em(7.5f));
    action_check(state, "layers.links");
    draw_curve_filter(state);
}

void draw_shading(AppState &state) {
    heading("Shading");
    const float width = ImGui::GetContentRegionAvail().x - 2;
    action_button(state, "layers.polynomial", "Polynomial", {0.43f * width, 0});
    ImGui::SameLine(0, 1);
    action_button(state, "layers.flat", "Flat", {0.25f * width, 0});
    ImGui::SameLine(0, 1);
    action_button(state, "layers.linear", "Linear", {0.32f * width, 0});
    action_check(state, "layers.false_colour");
    float ev = static_cast<float>(state.look.exposure_ev);
    field_label("exposure");
    if (ImGui::SliderFloat("##exposure", &ev, -6, 6, "%+.1f EV"))
        state.look.exposure_ev = ev;
    mark(state, "exposure");
    tooltip("Exposure", "Radiosity is multiplied by two to this power before it is shown, in all panes alike.", "E");
}

/// Sliders move freely; the solution starts anew when one is let go.
void draw_options(AppState &state) {
    heading("Solution");
    static constexpr float lowest = 1e-3f, highest = 50; // percent
    ImGuiStorage &edited = *ImGui::GetStateStorage();
    const ImGuiID run_id = ImGui::GetID("run"), threshold_id = ImGui::GetID("threshold"), depth_id = ImGui::GetID("depth");
    if (edited.GetInt(run_id, 0) != static_cast<int>(state.run)) {
        edited.SetInt(run_id, static_cast<int>(state.run));
        edited.SetFloat(threshold_id, static_cast<float>(100 * state.options.threshold));
        edited.SetInt(depth_id, state.options.max_depth);
    }
    Options options = state.options;

    field_label("threshold");
    ImGui::SliderFloat("##threshold", edited.GetFloatRef(threshold_id), lowest, highest, "%.3g %%",
                       ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat);
    bool done = ImGui::IsItemDeactivatedAfterEdit();
    mark(state, "threshold");
    tooltip("Threshold", "Largest misfit that is let pass, as a share of the largest reflected radiosity. "
                         "Another value starts the solution anew.");
    field_label("depth limit");
    ImGui::SliderInt("##depth", edited.GetIntRef(depth_id), 0, 10);
    done |= ImGui::IsItemDeactivatedAfterEdit();
    mark(state, "depth");
    tooltip("Depth limit", "How often the sides of a surface may be halved; the paper allows 6.");
    if (done) {
        options.threshold = static_cast<double>(edited.GetFloat(threshold_id)) / 100;
        options.max_depth = edited.GetInt(depth_id);
    }

    field_label("order M");
    const float quarter = (ImGui::GetContentRegionAvail().x - 3) / 4;
    for (int order = 1; order <= 4; ++order) {
        if (order > 1)
            ImGui::SameLine(0, 1);
        const std::string text = std::to_string(order);
        if (choice(state, "order " + text, text.c_str(), options.order == order,
                   "Multiwavelet polynomials have a degree below this in each direction.", {quarter, 0})) {
            done = done || options.order != order;
            options.order = order;
        }
    }
    field_label("elements");
    const float half = (ImGui::GetContentRegionAvail().x - 1) / 2;
    for (const BasisFamily family : {BasisFamily::parametric, BasisFamily::planar}) {
        const bool planar = family == BasisFamily::planar;
        if (planar)
            ImGui::SameLine(0, 1);
        if (choice(state, "basis " + std::string(name(family)), planar ? "convex" : "quads", options.basis == family,
                   planar ? "Polynomials of the plane on convex polygons of any shape: cuts lose nothing."
                          : "The paper's products of polynomials in the two parameters of a quad.",
                   {half, 0})) {
            done = done || options.basis != family;
            options.basis = family;
        }
    }
    if (done)
        set_options(state, options);
}

void draw_figures(const AppState &state) {
    const Strategy strategy = state.active_strategy();
    heading((std::string("Pane (") + letter(strategy) + ")").c_str());
    const auto snapshot = state.snapshot(strategy);
    if (!snapshot) {
        ImGui::TextDisabled("preparing…");
        return;
    }
    const Counters &c = snapshot->counters;
    figure("patches", count_words(c.patches), "Leaves of the surfaces that reflect.");
    figure("coefficients", count_words(c.coefficients), "Basis functions on these patches.");
    figure("links", count_words(c.links), "Pairs of elements that exchange light.");
    figure("splits, of these cuts", count_words(c.splits) + ", " + count_words(c.cuts), "In this iteration.");
    figure("kernel evaluations", count_words(c.total_work.kernel_evaluations), "Of all iterations so far.");
    figure("clips", count_words(c.total_work.clips), "Sources clipped by one blocker's shadow, for one point.");
    if (c.nodes_at_limit > 0)
        figure("at the depth limit", count_words(c.nodes_at_limit), "Patches that fit poorly and may not be split.");
    if (c.iteration > 0)
        figure("change", number_words(100 * c.change) + " %", "Of radiosity in this iteration, of its largest value.");
    if (snapshot->error >= 0)
        figure("error", number_words(100 * snapshot->error) + " %", "Relative L2, against the exact direct solution.");
    figure("time", seconds_words(c.seconds), "Of all iterations so far.");
}

void draw_cursor(const AppState &state) {
    heading("Under the cursor");
    const auto snapshot = state.snapshot(state.active_strategy());
    if (!state.under_cursor || !snapshot ||
        state.under_cursor->surface >= static_cast<int>(snapshot->surfaces.size())) {
        ImGui::TextDisabled("point at a surface");
        return;
    }
    const Pick &pick = *state.under_cursor;
    const auto &surface = snapshot->surfaces[static_cast<std::size_t>(pick.surface)];
    figure("surface", surface.name.empty() ? std::to_string(pick.surface) : surface.name);
    if (pick.patch >= 0)
        figure("patch", count_words(pick.patch));
    figure("radiosity", rgb_words(pick.radiosity) + " W/m²", "Red, green, blue; one number where they are equal.");
    figure("reflectance", rgb_words(surface.reflectance), "Red, green, blue; one number where they are equal.");
}

} // namespace

void draw_side_panel(AppState &state, const WindowRect &rect) {
    begin_panel("side", rect);
    draw_layers(state);
    draw_shading(state);
    draw_options(state);
    draw_figures(state);
    draw_cursor(state);
    ImGui::End();
}

} // namespace penumbra
