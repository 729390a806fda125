#include "panels/controls.h"
#include "panels/navigation.h"
#include "panels/panels.h"
#include "verbs.h"

#include <string>
#include <vector>

namespace penumbra {

namespace {

bool mouse_moved_since_press(ImGuiMouseButton button) { return ImGui::IsMouseDragging(button, 0); }

/// Which drag a held button means; Shift and the left button pan, for mice with one.
enum class Drag { none, orbit, pan };
Drag drag_of(const ImGuiIO &io) {
    if (ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle))
        return Drag::pan;
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left))
        return io.KeyShift ? Drag::pan : Drag::orbit;
    return Drag::none;
}

void begin_drag(AppState &state, const glm::dvec3 &point, int pane) {
    state.panes().active = pane;
    state.drag_anchor = point;
    state.orbit_pivot = state.pivot.value_or(point);
}

void handle_mouse(AppState &state, const WindowRect &rect, int pane) {
    const ImGuiIO &io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    const double aspect = static_cast<double>(rect.width / rect.height);
    const auto snapshot = state.snapshot(state.panes().strategies[static_cast<std::size_t>(pane)]);
    const FramePoint at = frame_point(rect, static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y));
    if (ImGui::IsItemActivated())
        begin_drag(state, point_under(state, snapshot.get(), aspect, at), pane);
    if (ImGui::IsItemActive() && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
        const auto dx = static_cast<double>(io.MouseDelta.x), dy = static_cast<double>(io.MouseDelta.y);
        const auto height = static_cast<double>(rect.height);
        const Drag drag = drag_of(io);
        if (drag == Drag::orbit && mouse_moved_since_press(ImGuiMouseButton_Left))
            orbit_by(state, dx, dy, height);
        else if (drag == Drag::pan)
            pan_by(state, dx, dy, height);
    }
    if (ImGui::IsItemDeactivated())
        state.orbit_pivot.reset();
    if (!hovered)
        return;
    if (io.MouseWheel != 0)
        zoom_by(state, static_cast<double>(io.MouseWheel), point_under(state, snapshot.get(), aspect, at));
    if (snapshot)
        state.under_cursor = pick(*snapshot, state.camera, aspect, at.x, at.y);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        state.pivot = point_under(state, snapshot.get(), aspect, at);
        state.message = {"Views now turn about the point that was clicked; R goes back.", false};
    }
}

/// Returns its height.
float draw_label(AppState &state, ImDrawList &list, const Fonts &fonts, const WindowRect &rect, int pane) {
    const Strategy strategy = state.panes().strategies[static_cast<std::size_t>(pane)];
    const ImVec2 low{rect.x, rect.y}, high{rect.x + rect.width, rect.y + rect.height};
    const std::string tag = std::string("(") + letter(strategy) + ")";
    float height = 0;
    if (const auto snapshot = state.snapshot(strategy))
        height = draw_pane_label(list, fonts, low, high, pane_label(*snapshot, tag), state.look.theme);
    else if (state.scene)
        list.AddText({low.x + em(0.8f), low.y + em(0.6f)}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                     (tag + " finding the discontinuity curves…").c_str());
    if (state.layout != Layout::single && pane == state.panes().active && !state.panels_hidden)
        list.AddRect({low.x + 1, low.y + 1}, {high.x - 1, high.y - 1}, ImGui::GetColorU32(ImGuiCol_CheckMark), 0, 0, 2);
    return height;
}

/// `below`: height of the label of the pane that the scale stands in.
void draw_legends(const AppState &state, ImDrawList &list, const Fonts &fonts, const Arrangement &arrangement,
                  float below) {
    std::vector<const Snapshot *> snapshots;
    std::vector<std::shared_ptr<const Snapshot>> kept;
    for (const Strategy s : state.shown())
        if (auto snapshot = state.snapshot(s)) {
            snapshots.push_back(snapshot.get());
            kept.push_back(std::move(snapshot));
        }
    if (snapshots.empty() || arrangement.legend.height <= 0)
        return;
    const Range range = state.look.range.value_or(common_range(snapshots));
    const WindowRect &strip = arrangement.legend;
    draw_line_legend(list, fonts, {strip.x + em(0.8f), strip.y + 0.4f * em()}, strip.width - em(1.6f), state.look,
                     snapshots);
    const WindowRect &pane = arrangement.pane[state.layout == Layout::single ? 0 : 1];
    draw_colour_legend(list, fonts, {pane.x + pane.width - em(0.9f), pane.y + em(0.9f) + below},
                       std::min(em(14), 0.5f * (pane.height - below)), state.look, range);
}

} // namespace

void draw_panes(AppState &state, const Arrangement &arrangement, const Fonts &fonts) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::SetNextWindowPos({arrangement.panes.x, arrangement.panes.y});
    ImGui::SetNextWindowSize({arrangement.panes.width, arrangement.panes.height});
    ImGui::Begin("panes", nullptr, panel_flags() | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                                       ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    state.under_cursor.reset();
    ImDrawList &list = *ImGui::GetWindowDrawList();
    float below = 0; // one pane is wide enough for label and scale side by side
    for (int pane = 0; pane < static_cast<int>(arrangement.pane.size()); ++pane) {
        const WindowRect &rect = arrangement.pane[static_cast<std::size_t>(pane)];
        const std::string name = "pane " + std::to_string(pane);
        ImGui::SetCursorScreenPos({rect.x, rect.y});
        ImGui::InvisibleButton(name.c_str(), {rect.width, rect.height},
                               ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                                   ImGuiButtonFlags_MouseButtonMiddle);
        mark(state, name);
        handle_mouse(state, rect, pane);
        const float height = draw_label(state, list, fonts, rect, pane);
        if (pane == 1)
            below = height;
    }
    draw_legends(state, list, fonts, arrangement, below);
    ImGui::End();
    ImGui::PopStyleVar();
}

} // namespace penumbra
