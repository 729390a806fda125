// What is solved for: by which measure, how exactly, in what elements.
#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "paper_lines.h"
#include "price_verbs.h"
#include "verbs.h"

#include <cmath>
#include <optional>
#include <string>

namespace penumbra {

namespace {

/// By what the solution is asked for. Returns whether that has changed.
bool draw_asked(AppState &state, Options &options) {
    const bool by_tolerance = options.tolerance.has_value();
    ButtonRow measures({"By threshold", "By tolerance"});
    if (choice(state, "asked threshold", "By threshold", !by_tolerance,
               "The misfit that a patch may have is given, as in the paper; the error follows.", measures.next()) &&
        by_tolerance) {
        options = options.to_threshold(options.threshold);
        return true;
    }
    if (choice(state, "asked tolerance", "By tolerance", by_tolerance,
               "The error that the whole solution may have is given; the solver finds its thresholds.", measures.next()) &&
        !by_tolerance) {
        options = options.to_tolerance(state.asked_tolerance);
        return true;
    }
    return false;
}

/// On a logarithmic scale [percent]. Returns whether it was let go with another value.
bool share_slider(const char *label, float &percent, float low, float high) {
    ImGui::SliderFloat(label, &percent, low, high, "%.3g %%",
                       ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoRoundToFormat);
    return ImGui::IsItemDeactivatedAfterEdit();
}

/// Returns whether the value was let go with another value.
bool draw_threshold(AppState &state, Options &options, float &percent) {
    field_label("threshold");
    const bool done = share_slider("##threshold", percent, 1e-3f, 50);
    mark(state, "threshold");
    tooltip("Threshold", "Largest misfit that is let pass, as a share of the largest reflected radiosity. "
                         "Another value starts the solution anew.",
            {}, paper_line("threshold"));
    if (done)
        options.threshold = static_cast<double>(percent) / 100;
    return done;
}

/// Returns whether the value was let go with another value.
bool draw_depth(AppState &state, Options &options, int &depth) {
    field_label("depth limit");
    ImGui::SliderInt("##depth", &depth, 0, state.options.tolerance ? deepest : 10);
    const bool done = ImGui::IsItemDeactivatedAfterEdit();
    mark(state, "depth");
    tooltip("Depth limit", "How often the sides of a surface may be halved; the paper allows 6.", {}, paper_line("depth"));
    if (done)
        options.max_depth = depth;
    return done;
}

Price price_of(const Counters &c) {
    return {c.seconds, static_cast<double>(c.link_bytes), static_cast<double>(c.patches)};
}

/// Predicted, and beside it what it has come to, if that is known.
void draw_prices(const Price &predicted, const std::optional<Price> &actual) {
    if (!ImGui::BeginTable("prices", 3, ImGuiTableFlags_SizingStretchProp))
        return;
    const auto row = [&](const char *what, const auto &words) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", what);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(words(predicted).c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(actual ? words(*actual).c_str() : "");
    };
    for (const char *head : {"", "predicted", actual ? "actual" : ""}) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", head);
    }
    row("time", [](const Price &p) { return seconds_words(p.seconds); });
    row("patches", [](const Price &p) { return count_words(std::llround(p.patches)); });
    row("memory", [](const Price &p) { return memory_words(p.bytes); });
    ImGui::EndTable();
}

/// While the slider moves: what its tolerance would cost. Else what was predicted, and what it has come to.
void draw_price_tag(AppState &state, double tolerance) {
    const Strategy strategy = state.active_strategy();
    const auto snapshot = state.active_solution();
    const std::optional<Price> said = state.tolerance_in_hand
                                          ? price_tag(state, strategy, tolerance)
                                          : state.prices.predicted[static_cast<std::size_t>(strategy)];
    const bool paid = !state.tolerance_in_hand && snapshot && snapshot->counters.converged;
    ImGui::BeginGroup();
    if (said)
        draw_prices(*said, paid ? std::optional(price_of(snapshot->counters)) : std::nullopt);
    else if (state.tolerance_in_hand)
        ImGui::TextDisabled("price not known: nothing measured yet");
    ImGui::EndGroup();
    mark(state, "price tag");
    tooltip("Price", "Time, patches and memory of the links in the active pane. Predicted from what was measured on this scene "
                     "so far; how prices grow beyond that was measured on the bundled scenes.");
}

bool draw_tolerance(AppState &state, Options &options, float &percent) {
    field_label("tolerance");
    const bool done = share_slider("##tolerance", percent, 0.02f, 30);
    const double value = static_cast<double>(percent) / 100;
    state.tolerance_in_hand = ImGui::IsItemActive() ? std::optional(value) : std::nullopt;
    mark(state, "tolerance");
    if (!state.tolerance_in_hand) // it would stand on the price
        tooltip("Tolerance", "Error that the whole solution may have: relative L2 of the reflected radiosity, over all "
                             "reflecting surfaces. Another value starts the solution anew; while the slider moves, its price "
                             "is told.",
                {}, paper_line("tolerance"));
    if (done)
        options.tolerance = state.asked_tolerance = value;
    draw_price_tag(state, value);
    return done;
}

} // namespace

/// Sliders move freely; the solution starts anew when one is let go.
void draw_solution(AppState &state) {
    heading("Solution");
    ImGuiStorage &edited = *ImGui::GetStateStorage();
    const ImGuiID run_id = ImGui::GetID("run"), asked_id = ImGui::GetID("asked"), depth_id = ImGui::GetID("depth");
    if (edited.GetInt(run_id, 0) != static_cast<int>(state.run)) {
        edited.SetInt(run_id, static_cast<int>(state.run));
        edited.SetFloat(asked_id, static_cast<float>(100 * state.options.tolerance.value_or(state.options.threshold)));
        edited.SetInt(depth_id, state.options.max_depth);
    }
    Options options = state.options;
    bool done = draw_asked(state, options);
    if (state.options.tolerance)
        done |= draw_tolerance(state, options, *edited.GetFloatRef(asked_id));
    else
        done |= draw_threshold(state, options, *edited.GetFloatRef(asked_id));
    if (!state.options.tolerance || state.options.max_depth < deepest) // which is as good as none
        done |= draw_depth(state, options, *edited.GetIntRef(depth_id));

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
    if (done && options.tolerance && options.tolerance != state.options.tolerance)
        ask_for_tolerance(state, options);
    else if (done)
        set_options(state, options);
}

} // namespace penumbra
