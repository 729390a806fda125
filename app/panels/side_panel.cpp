#include "core/percent.h"
#include "panels/accuracy_words.h"
#include "iteration/error_map.h"
#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "render/error_scale.h"
#include "truth_verbs.h"
#include "verbs.h"

#include <string>

namespace penumbra {

namespace {

/// The next check box stands there in this line, or begins the next where it would be cut.
void beside(float at, const char *text) {
    const float width = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(text).x;
    if (at + width <= ImGui::GetWindowContentRegionMax().x)
        ImGui::SameLine(at);
}

void draw_layers(AppState &state) {
    heading("Show");
    action_check(state, "layers.mesh");
    beside(em(7.5f), "New patches");
    action_check(state, "layers.fresh", "New patches");
    action_check(state, "layers.curves", "Curves");
    beside(em(7.5f), "Links");
    action_check(state, "layers.links");
    draw_curve_filter(state);
}

/// What of the error is shown.
void draw_errors(AppState &state) {
    ButtonRow light({"signed", "relative"}), patches({"of each patch", "vs. estimate"});
    action_button(state, "error.signed", "signed", light.next());
    action_button(state, "error.relative", "relative", light.next());
    action_button(state, "error.patch", "of each patch", patches.next());
    action_button(state, "error.estimate", "vs. estimate", patches.next());
    action_check(state, "layers.lock_range");
}

void draw_shading(AppState &state) {
    if (state.layout == Layout::difference) {
        heading("Difference");
        action_check(state, "layers.lock_range");
        return;
    }
    heading("Shading");
    ButtonRow kinds({"Polynomial", "Flat", "Linear", "Error"});
    action_button(state, "layers.polynomial", "Polynomial", kinds.next());
    action_button(state, "layers.flat", "Flat", kinds.next());
    action_button(state, "layers.linear", "Linear", kinds.next());
    action_button(state, "layers.error", "Error", kinds.next());
    if (state.look.shading == Shading::error) {
        draw_errors(state);
        return;
    }
    action_check(state, "layers.false_colour");
    action_check(state, "layers.lock_range");
    float ev = static_cast<float>(state.look.exposure_ev);
    field_label("exposure");
    if (ImGui::SliderFloat("##exposure", &ev, -6, 6, "%+.1f EV"))
        state.look.exposure_ev = ev;
    mark(state, "exposure");
    tooltip("Exposure", "Radiosity is multiplied by two to this power before it is shown, in all panes alike.", "E");
}

/// What was measured of the error, and where that leaves what was asked for.
void draw_accuracy(const Snapshot &snapshot) {
    const Counters &c = snapshot.counters;
    if (!snapshot.options.tolerance)
        return;
    if (c.estimated_error >= 0) {
        figure("error, about", percent(c.estimated_error) + ", \u2264 " + percent(c.error_limit),
               "Relative L2 of the reflected radiosity, measured at fresh random points, apart from the links. With 99 % "
               "confidence it is not above the second number.");
        figure("error, at most", percent(c.error_bound),
               "The error is not above this, with 99 % confidence, however it is spread: the residual over 1 minus the largest "
               "reflectance.");
    }
    if (c.threshold > 0)
        figure("threshold in force", percent(c.threshold),
               "Largest misfit that is let pass now. It falls until the error measured is below the tolerance.");
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(accuracy_words(snapshot).c_str());
    ImGui::PopTextWrapPos();
}

void draw_figures(const AppState &state) {
    const Strategy strategy = state.active_strategy();
    heading((std::string("Pane (") + letter(strategy) + ")").c_str());
    const auto snapshot = state.shown_snapshot(state.panes().active);
    if (!snapshot) {
        ImGui::TextDisabled("preparing…");
        return;
    }
    const Counters &c = snapshot->counters;
    figure("patches", count_words(c.patches), "Leaves of the surfaces that reflect.");
    figure("coefficients", count_words(c.coefficients), "Basis functions on these patches.");
    figure("links", count_words(c.links), "Pairs of elements that exchange light.");
    figure("links × coefficients", count_words(c.link_coefficients),
           "Transport coefficients of all links: the work of one gather. A patch is not a unit of work: with M = 4 it may take "
           "16 times the effort of a constant one.");
    figure("splits, of these cuts", count_words(c.splits) + ", " + count_words(c.cuts), "Elements that this iteration has split, and how many of them along a curve.");
    figure("kernel evaluations", count_words(c.total_work.kernel_evaluations), "Of all iterations so far.");
    figure("clips", count_words(c.total_work.clips), "Sources clipped by one blocker's shadow, for one point.");
    if (c.nodes_at_limit > 0)
        figure("at the depth limit", count_words(c.nodes_at_limit), "Patches that fit poorly and may not be split.");
    if (c.iteration > 0)
        figure("change", number_words(100 * c.change) + " %", "Of radiosity in this iteration, of its largest value.");
    if (snapshot->error >= 0)
        figure("error", number_words(100 * snapshot->error) + " %", "Relative L2, against the exact direct solution.");
    draw_accuracy(*snapshot);
    figure("time", seconds_words(c.seconds), "Of all iterations so far.");
}

void draw_cursor(const AppState &state) {
    heading("Under the cursor");
    const auto snapshot = state.shown_snapshot(state.panes().active);
    if (!state.under_cursor || !snapshot ||
        state.under_cursor->surface >= static_cast<int>(snapshot->surfaces.size())) {
        ImGui::TextDisabled("point at a surface");
        return;
    }
    const Pick &pick = *state.under_cursor;
    const auto &surface = snapshot->surfaces[static_cast<std::size_t>(pick.surface)];
    figure("surface", surface.name.empty() ? std::to_string(pick.surface) : surface.name,
           "Its name in the scene's file, or its number there.");
    if (pick.patch >= 0)
        figure("patch", count_words(pick.patch), "Its number among all patches of this step.");
    figure("radiosity", rgb_words(pick.radiosity) + " W/m²", "Red, green, blue; one number where they are equal.");
    if (const auto difference = difference_under_cursor(state))
        figure("difference", number_words(difference->mean()) + " W/m²", "The second strategy minus the first, here: mean of red, green, blue.");
    if (const auto errors = errors_of(state, state.panes().active);
        errors && pick.patch >= 0 && state.look.shading == Shading::error) {
        const auto patch = static_cast<std::size_t>(pick.patch);
        figure("its part of the error", number_words(100 * errors->share(patch)) + " %",
               "L2 error of this patch, over the L2 norm of the reflected radiosity of the scene.");
        if (const double ratio = patch_value(ErrorKind::estimate, *snapshot, *errors, patch); ratio > 0)
            figure("true / estimated", number_words(ratio), "Its error over what the oracle's test points saw.");
    }
    figure("reflectance", rgb_words(surface.reflectance), "Red, green, blue; one number where they are equal.");
}

} // namespace

void draw_side_panel(AppState &state, const WindowRect &rect) {
    if (rect.width <= 0)
        return;
    begin_panel("side", rect);
    draw_layers(state);
    draw_shading(state);
    draw_solution(state);
    draw_figures(state);
    draw_cursor(state);
    ImGui::End();
}

} // namespace penumbra
