// Which curves are shown: by kind, by order, by source.
#include "panels/controls.h"
#include "panels/panels.h"
#include "render/event_words.h"

#include <set>
#include <string>

namespace penumbra {

namespace {

void draw_kinds(AppState &state) {
    struct Kind {
        const char *name, *sentence;
    };
    static constexpr Kind kinds[] = {{"VE", "A corner goes behind an edge."},
                                     {"EV", "A corner comes before an edge."},
                                     {"EEE", "Three edges seem to meet."},
                                     {"plane", "A polygon is seen edge-on."},
                                     {"contact", "A blocker touches the receiver."}};
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {em(0.2f), ImGui::GetStyle().FramePadding.y});
    ButtonRow row({"VE", "EV", "EEE", "plane", "contact"});
    for (std::size_t k = 0; k < 5; ++k) {
        bool &on = state.look.curve_filter.kinds[k];
        if (choice(state, std::string("kind ") + kinds[k].name, kinds[k].name, on, kinds[k].sentence, row.next()))
            on = !on;
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        if (on) // in the colour that the curve is drawn in
            ImGui::GetWindowDrawList()->AddRectFilled(
                {low.x, high.y - em(0.2f)}, high, ImGui::ColorConvertFloat4ToU32(curve_colour(static_cast<int>(k))));
    }
    ImGui::PopStyleVar();
}

void draw_orders(AppState &state) {
    static constexpr const char *names[] = {"0", "1", "2"};
    static constexpr const char *sentences[] = {"Curves across which the irradiance itself jumps.",
                                                "Curves across which its slope jumps.",
                                                "Curves across which its curvature jumps."};
    field_label("order");
    for (std::size_t k = 0; k < 3; ++k) {
        if (k > 0)
            ImGui::SameLine(0, 1);
        bool &on = state.look.curve_filter.orders[k];
        if (choice(state, std::string("curve order ") + names[k], names[k], on, sentences[k], {em(2.1f), 0}))
            on = !on;
    }
}

void draw_sources(AppState &state, const Snapshot &snapshot) {
    std::set<int> sources;
    for (const SnapshotCurve &curve : *snapshot.curves)
        sources.insert(curve.source);
    int &chosen = state.look.curve_filter.source;
    if (sources.size() < 2 && chosen < 0)
        return;
    field_label("of source");
    const bool open = ImGui::BeginCombo("##source", chosen < 0 ? "all" : surface_name(snapshot, chosen).c_str());
    if (!open) {
        mark(state, "curve source");
        tooltip("Source", "Only the curves that this light or reflector throws.");
        return;
    }
    if (ImGui::Selectable("all", chosen < 0))
        chosen = -1;
    mark(state, "curve source all");
    tooltip("All sources", "The curves of every light and reflector.");
    for (const int source : sources) {
        ImGui::PushID(source);
        if (ImGui::Selectable((surface_name(snapshot, source) + " (" + std::to_string(source) + ")").c_str(),
                              chosen == source))
            chosen = source;
        ImGui::PopID();
        mark(state, "curve source " + std::to_string(source));
        tooltip(surface_name(snapshot, source), "Only the curves that it throws.");
    }
    ImGui::EndCombo();
}

} // namespace

void draw_curve_filter(AppState &state) {
    const auto snapshot = state.active_solution();
    if (!state.look.layers.curves || !snapshot || !snapshot->curves)
        return;
    draw_kinds(state);
    draw_orders(state);
    draw_sources(state, *snapshot);
}

} // namespace penumbra
