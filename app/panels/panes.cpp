#include "element_verbs.h"
#include "keyhole_verbs.h"
#include "microscope_verbs.h"
#include "panels/controls.h"
#include "panels/navigation.h"
#include "panels/object_drag.h"
#include "panels/panels.h"
#include "panels/split_sketch.h"
#include "pane_verbs.h"
#include "profile_verbs.h"
#include "render/divider.h"
#include "render/event_note.h"
#include "render/pick_curve.h"
#include "render/surface_role.h"
#include "truth_verbs.h"
#include "verbs.h"

#include <cmath>
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
    activate(state, pane);
    state.drag_anchor = point;
    state.orbit_pivot = state.pivot.value_or(point);
}

constexpr float curve_reach = 0.4f; // text heights: six pixels

/// A press and a release in one place, however short the way the hand trembled.
bool clicked() {
    const float threshold = ImGui::GetIO().MouseDragThreshold;
    return ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
           ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < threshold * threshold;
}

void tell_curve(const Snapshot &snapshot, int curve) {
    const EventWords words = event_words(snapshot, (*snapshot.curves)[static_cast<std::size_t>(curve)]);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {em(0.6f), em(0.4f)});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(em(24));
    ImGui::TextUnformatted((words.sentence + " " + words.jump).c_str());
    ImGui::TextDisabled("%s  \u00b7  %s", words.symbol.c_str(), words.way.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

/// The curve near the mouse is told of and lit up; a click pins it, a click elsewhere lets go.
void point_at_curves(AppState &state, const Snapshot &snapshot, const WindowRect &rect, const Camera &camera,
                     const FramePoint &at) {
    const bool dragging = ImGui::IsItemActive() && !clicked() && ImGui::GetIO().MouseDragMaxDistanceSqr[0] > 0;
    if (!state.look.layers.curves || dragging)
        return;
    const auto aspect = static_cast<double>(rect.width / rect.height);
    const auto found = pick_curve(snapshot, camera, aspect, at.x, at.y, static_cast<double>(rect.height),
                                  static_cast<double>(em(curve_reach)), state.look.curve_filter);
    if (found)
        state.hovered_curve = found->curve;
    if (clicked() && state.inspector != Inspector::filters) // which takes clicks for itself
        state.pinned_curve = state.hovered_curve;
    else if (found && !ImGui::IsItemActive() && state.pinned_curve != found->curve)
        tell_curve(snapshot, found->curve);
}

/// With the keyhole open, a drag that begins on a surface that reflects moves the point that looks.
void drag_keyhole(AppState &state, const Snapshot *snapshot, double aspect, const FramePoint &at) {
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        if (ImGui::IsItemDeactivated())
            state.keyhole.dragging = false;
        return;
    }
    const bool begins = ImGui::IsItemActivated() && state.keyhole.open && !ImGui::GetIO().KeyShift;
    if (!snapshot || !(begins || state.keyhole.dragging))
        return;
    const auto found = pick(*snapshot, state.active_camera(), aspect, at.x, at.y);
    const auto reflects = [&](int surface) {
        return role(snapshot->surfaces[static_cast<std::size_t>(surface)]) == SurfaceRole::reflector;
    };
    if (!found || !reflects(found->surface))
        return;
    state.keyhole.dragging = true;
    move_keyhole(state, found->surface, found->point);
}

/// Where the point stands in the active pane.
std::optional<ImVec2> on_screen(const AppState &state, const WindowRect &rect, const Vec3 &p) {
    const auto at = place_in_frame(state.active_camera(), static_cast<double>(rect.width / rect.height), {p.x(), p.y(), p.z()});
    if (!at)
        return std::nullopt;
    return ImVec2(rect.x + rect.width * static_cast<float>(0.5 + 0.5 * at->x),
                  rect.y + rect.height * static_cast<float>(0.5 - 0.5 * at->y));
}

/// With the profile open, a drag that begins at an end of its line moves that end, one that begins elsewhere on a
/// surface that reflects draws the line anew.
void drag_profile(AppState &state, const Snapshot *snapshot, const WindowRect &rect, const FramePoint &at) {
    ProfileMode &mode = state.profile;
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        if (ImGui::IsItemDeactivated())
            mode.dragging = ProfileGrip::none;
        return;
    }
    if (!snapshot || !mode.open)
        return;
    const auto found = pick(*snapshot, state.active_camera(), static_cast<double>(rect.width / rect.height), at.x, at.y);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemActivated())
        mode.pressed.reset();
    if (ImGui::IsItemActivated() && !ImGui::GetIO().KeyShift) {
        const auto near = [&](const Vec3 &end) {
            const auto p = on_screen(state, rect, end);
            return p && std::hypot(p->x - mouse.x, p->y - mouse.y) < em(0.9f);
        };
        if (mode.line && near(mode.line->from))
            mode.dragging = ProfileGrip::from;
        else if (mode.line && near(mode.line->to))
            mode.dragging = ProfileGrip::to;
        else if (found &&
                 role(snapshot->surfaces[static_cast<std::size_t>(found->surface)]) == SurfaceRole::reflector) {
            mode.dragging = ProfileGrip::to;
            mode.pressed = SurfacePoint{found->surface, found->point};
            return;
        }
    }
    if (mode.dragging == ProfileGrip::none || !found || !mouse_moved_since_press(ImGuiMouseButton_Left))
        return;
    if (mode.pressed && ImGui::GetIO().MouseDragMaxDistanceSqr[0] < em(0.4f) * em(0.4f))
        return;
    const int surface = mode.pressed ? mode.pressed->surface : mode.line->surface;
    if (found->surface != surface)
        return;
    const Vec3 from = mode.pressed                         ? mode.pressed->point
                      : mode.dragging == ProfileGrip::from ? mode.line->to
                                                           : mode.line->from;
    mode.pressed.reset(); // from now on it is an end that is dragged
    if (mode.dragging == ProfileGrip::from)
        set_profile(state, surface, found->point, from);
    else
        set_profile(state, surface, from, found->point);
}

/// The place on the line that the mouse is near in a pane is told of in the plot.
void point_at_profile(AppState &state) {
    ProfileMode &mode = state.profile;
    if (!mode.open || !mode.line || mode.cursor_in_plot)
        return;
    if (!state.under_cursor || state.under_cursor->surface != mode.line->surface || ImGui::IsItemActive())
        return;
    const Vec3 way = mode.line->to - mode.line->from, off = state.under_cursor->point - mode.line->from;
    const double part = off.dot(way) / way.squaredNorm();
    if (part >= 0 && part <= 1 && (off - part * way).norm() < 0.03 * mode.line->length())
        mode.cursor = part * mode.line->length();
}

void handle_mouse(AppState &state, const WindowRect &rect, int pane) {
    const ImGuiIO &io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    const double aspect = static_cast<double>(rect.width / rect.height);
    const auto snapshot = state.shown_snapshot(pane);
    const Camera camera = state.camera_of(pane);
    const FramePoint at = frame_point(rect, static_cast<double>(io.MousePos.x), static_cast<double>(io.MousePos.y));
    if (ImGui::IsItemActivated())
        begin_drag(state, point_under(camera, snapshot.get(), aspect, at), pane);
    const bool held = drag_object(state, snapshot.get(), aspect, at) || state.keyhole.dragging ||
                      state.profile.dragging != ProfileGrip::none; // also in the frame in which it is let go
    drag_keyhole(state, snapshot.get(), aspect, at);
    drag_profile(state, snapshot.get(), rect, at);
    if (ImGui::IsItemActive() && !held && !state.keyhole.dragging && state.profile.dragging == ProfileGrip::none &&
        (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
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
        zoom_by(state, pane, static_cast<double>(io.MouseWheel), point_under(camera, snapshot.get(), aspect, at));
    if (snapshot)
        state.under_cursor = pick(*snapshot, state.camera_of(pane), aspect, at.x, at.y);
    point_at_profile(state);
    if (state.inspector == Inspector::filters && state.under_cursor && clicked() && !held)
        pick_split(state, {state.under_cursor->surface, state.under_cursor->point});
    if (state.inspector == Inspector::element && state.under_cursor && state.under_cursor->patch >= 0 && clicked() && !held)
        pick_element(state, {state.under_cursor->surface, state.under_cursor->point});
    if (snapshot && snapshot->curves && !held && !state.keyhole.dragging && state.profile.dragging == ProfileGrip::none)
        point_at_curves(state, *snapshot, rect, state.camera_of(pane), at);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        state.pivot = point_under(state.camera_of(pane), snapshot.get(), aspect, at);
        state.message = {"Views now turn about the point that was clicked; R goes back.", false};
    }
}

/// Of error pictures; others tell the snapshot's own error.
std::shared_ptr<const ErrorMap> shown_errors(const AppState &state, int pane) {
    return state.shown_look().shading == Shading::error ? errors_of(state, pane) : nullptr;
}

PaneLabel label_of(const AppState &state, const Snapshot &snapshot, int pane, const std::string &tag) {
    const auto errors = shown_errors(state, pane);
    const auto minus = subtracted(state);
    return minus ? difference_label(*minus, snapshot, errors.get()) : pane_label(snapshot, tag, errors.get());
}

/// Where a pane's label stands: over its part of a wipe, as far as both labels are readable.
WindowRect label_place(const AppState &state, const WindowRect &pane, int number) {
    if (state.layout != Layout::wipe)
        return pane;
    WindowRect place = pane;
    const float left = std::round(static_cast<float>(label_share(state.wipe)) * pane.width);
    place.x += number == 0 ? 0 : left;
    place.width = number == 0 ? left : pane.width - left;
    return place;
}

/// Where more than one solution is to be seen.
void draw_active_frame(const AppState &state, ImDrawList &list, const WindowRect &part, int pane) {
    const bool several = n_places(state.layout) > 1 || state.layout == Layout::wipe;
    if (!several || pane != state.panes().active || state.panels_hidden)
        return;
    list.AddRect({part.x + 1, part.y + 1}, {part.x + part.width - 1, part.y + part.height - 1},
                 ImGui::GetColorU32(ImGuiCol_CheckMark), 0, 0, 2);
}

/// Returns its height.
float draw_label(AppState &state, ImDrawList &list, const Fonts &fonts, const WindowRect &rect, int pane) {
    const Strategy strategy = state.panes().strategies[static_cast<std::size_t>(pane)];
    const ImVec2 low{rect.x, rect.y}, high{rect.x + rect.width, rect.y + rect.height};
    const std::string tag = std::string("(") + letter(strategy) + ")";
    float height = 0;
    const auto snapshot = state.shown_snapshot(pane);
    const auto note = [&](const std::string &text) {
        list.AddText({low.x + em(0.6f), low.y + height + em(0.3f)}, ImGui::GetColorU32(ImGuiCol_CheckMark), text.c_str());
    };
    if (snapshot)
        height = draw_pane_label(list, fonts, low, high, label_of(state, *snapshot, pane, tag), state.look.theme, true);
    else if (state.scene)
        list.AddText({low.x + em(0.8f), low.y + em(0.6f)}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                     (tag + " finding the discontinuity curves…").c_str());
    if (state.awaits_reconstruction(pane))
        note("making quadratics\u2026");
    else if (state.shown_look().shading == Shading::error && snapshot && !errors_of(state, pane))
        note(state.truth.halted ? "the error was not measured" : state.truth.doing + "\u2026");
    return height;
}

/// What the pinned curve is, above the footnote; the keyhole needs the place for its news, and the inspector tells it.
void draw_pinned(const AppState &state, ImDrawList &list, const Fonts &fonts, const WindowRect &rect) {
    const auto snapshot = state.active_solution();
    const bool told_elsewhere = state.keyhole.open || (state.inspector == Inspector::element && !state.panels_hidden);
    if (told_elsewhere || !state.pinned_curve || !snapshot || !snapshot->curves ||
        *state.pinned_curve >= static_cast<int>(snapshot->curves->size()))
        return;
    const SnapshotCurve &curve = (*snapshot->curves)[static_cast<std::size_t>(*state.pinned_curve)];
    draw_event_note(&list, fonts, {rect.x + em(0.6f), rect.y + rect.height - em(2.2f)},
                    std::min(em(34), rect.width - em(1.2f)), event_words(*snapshot, curve), curve_colour(curve.kind),
                    state.look.theme);
}

/// The scale of colours in the corner of each place that has its own, or else of one of them. `labels`: heights of the panes'
/// labels, below which it stands where place is narrow.
void draw_colour_legends(const AppState &state, ImDrawList &list, const Fonts &fonts, const Arrangement &arrangement,
                         const std::vector<float> &labels) {
    for (std::size_t i = 0; i < arrangement.place.size(); ++i) {
        const bool usual = i == (arrangement.place.size() == 1 ? 0 : 1);
        const Look look = state.look_of(static_cast<int>(i));
        if ((!usual && !state.has_own_tones()) || !look.range)
            continue;
        const WindowRect &place = arrangement.place[i];
        const float below = arrangement.place.size() > 1 ? labels[i] : state.layout == Layout::wipe ? labels[1] : 0;
        draw_colour_legend(list, fonts, {place.x + place.width - em(0.9f), place.y + em(0.9f) + below},
                           std::min(em(14), 0.5f * (place.height - below)), look, *look.range);
    }
}

void draw_legends(const AppState &state, ImDrawList &list, const Fonts &fonts, const Arrangement &arrangement,
                  const std::vector<float> &labels) {
    const std::vector<std::shared_ptr<const Snapshot>> kept = state.shown_snapshots();
    std::vector<const Snapshot *> snapshots;
    for (const auto &snapshot : kept)
        snapshots.push_back(snapshot.get());
    if (snapshots.empty() || arrangement.legend.height <= 0)
        return;
    const WindowRect &strip = arrangement.legend;
    draw_line_legend(list, fonts, {strip.x + em(0.8f), strip.y + 0.4f * em()}, strip.width - em(1.6f), state.shown_look(), snapshots);
    draw_colour_legends(state, list, fonts, arrangement, labels);
}

} // namespace

void draw_panes(AppState &state, const Arrangement &arrangement, const Fonts &fonts) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::SetNextWindowPos({arrangement.panes.x, arrangement.panes.y});
    ImGui::SetNextWindowSize({arrangement.panes.width, arrangement.panes.height});
    ImGui::Begin("panes", nullptr,
                 panel_flags() | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    state.under_cursor.reset();
    state.hovered_curve.reset();
    if (!state.profile.cursor_in_plot)
        state.profile.cursor.reset();
    ImDrawList &list = *ImGui::GetWindowDrawList();
    drag_divider(state, arrangement);
    std::vector<float> labels(arrangement.pane.size()); // their heights
    for (int pane = 0; pane < static_cast<int>(arrangement.pane.size()); ++pane) {
        const WindowRect &rect = arrangement.pane[static_cast<std::size_t>(pane)];
        const WindowRect &part = arrangement.part[static_cast<std::size_t>(pane)];
        if (part.width <= 0)
            continue;
        const std::string name = "pane " + std::to_string(pane);
        ImGui::SetCursorScreenPos({part.x, part.y});
        ImGui::InvisibleButton(name.c_str(), {part.width, part.height},
                               ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                                   ImGuiButtonFlags_MouseButtonMiddle);
        mark(state, name);
        handle_mouse(state, rect, pane);
        list.PushClipRect({part.x, part.y}, {part.x + part.width, part.y + part.height}, true);
        labels[static_cast<std::size_t>(pane)] = draw_label(state, list, fonts, label_place(state, rect, pane), pane);
        draw_active_frame(state, list, part, pane);
        list.PopClipRect();
    }
    draw_legends(state, list, fonts, arrangement, labels);
    const std::vector<Strategy> shown = state.shown();
    for (std::size_t pane = 0; pane < arrangement.pane.size(); ++pane)
        if (const WindowRect &part = arrangement.part[pane]; shown[pane] == state.active_strategy() && part.width > 0) {
            list.PushClipRect({part.x, part.y}, {part.x + part.width, part.y + part.height}, true);
            draw_split_outline(state, list, arrangement.pane[pane], state.camera_of(static_cast<int>(pane)));
            draw_picked_element(state, list, arrangement.pane[pane], state.camera_of(static_cast<int>(pane)), fonts);
            list.PopClipRect();
        }
    for (std::size_t i = 0; i < arrangement.place.size(); ++i)
        draw_object_outline(state, list, arrangement.place[i], state.camera_of(static_cast<int>(i)));
    draw_profile_line(state, list, arrangement, fonts);
    draw_keyhole(state, list, arrangement, fonts);
    draw_pinned(state, list, fonts, arrangement.pane[static_cast<std::size_t>(state.panes().active)]);
    draw_divider(state, list, arrangement);
    ImGui::End();
    ImGui::PopStyleVar();
}

} // namespace penumbra
