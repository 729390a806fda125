#include "files/settings.h"
#include "panels/controls.h"
#include "panels/panels.h"
#include "panels/words.h"
#include "split_verbs.h"
#include "verbs.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

void draw_buttons(AppState &state) {
    const float size = em(1.9f);
    icon_button(state, "solve.reset", Icon::to_start, size);
    ImGui::SameLine(0, 2);
    icon_button(state, "solve.back", Icon::back, size);
    ImGui::SameLine(0, 2);
    icon_button(state, "solve.play", state.playing ? Icon::pause : Icon::play, size);
    ImGui::SameLine(0, 2);
    icon_button(state, "solve.step", Icon::forward, size);
    ImGui::SameLine(0, 2);
    icon_button(state, "solve.end", Icon::to_end, size);
    ImGui::SameLine(0, em(0.8f));
    action_button(state, "solve.sub_step", "Next phase", {0, size});
    ImGui::SameLine(0, 2);
    action_button(state, "solve.split", "Next split", {0, size});
    ImGui::SameLine(0, em(0.8f));
    held_button(state, "view.before", "Before", state.before_by_mouse, {0, size});
}

/// Under the beads: the splits of the refinement at which we stand, each a tick, cuts taller; those shown are full. A click
/// or a drag goes there.
void draw_splits(AppState &state, const ImVec2 &low, float width, float height) {
    const int n = n_splits(state);
    const auto here = shown_splits(state);
    const int shown = here.value_or(n);
    const float step = std::min(em(1.1f), width / static_cast<float>(n));
    if (step <= 0)
        return;
    ImDrawList &list = *ImGui::GetWindowDrawList();
    ImGui::SetCursorScreenPos(low);
    ImGui::InvisibleButton("splits", {step * static_cast<float>(n), height});
    mark(state, "splits");
    const auto &events = *state.active_solution()->events;
    const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.45f), full = ImGui::GetColorU32(ImGuiCol_Text),
                accent = ImGui::GetColorU32(ImGuiCol_CheckMark);
    for (int k = 1; k <= n; ++k) {
        const bool cut = events[static_cast<std::size_t>(k - 1)].cut, newest = here == k;
        const float x = low.x + step * (static_cast<float>(k) - 0.5f), reach = (cut || newest ? 0.42f : 0.22f) * height,
                    middle = low.y + 0.5f * height;
        list.AddLine({x, middle - reach}, {x, middle + reach}, newest ? accent : k <= shown ? full : faint,
                     newest ? 3.f : std::clamp(0.4f * step, 1.f, 2.f));
    }
    const int over = std::clamp(1 + static_cast<int>((ImGui::GetMousePos().x - low.x) / step), 1, n);
    tooltip("Split " + std::to_string(over) + " of " + std::to_string(n), events[static_cast<std::size_t>(over - 1)].sentence);
    if (ImGui::IsItemActive() && here != over) {
        state.playing = false;
        show_splits(state, over);
    }
}

/// Beside them: the pairs that it linked then, as a bar that is full as far as they are shown.
void draw_linkings(AppState &state, const ImVec2 &low, float width, float height) {
    const int n = n_linkings(state);
    if (width <= 0)
        return;
    const auto here = shown_linkings(state);
    const int shown = shown_splits(state) ? 0 : here.value_or(n);
    ImDrawList &list = *ImGui::GetWindowDrawList();
    ImGui::SetCursorScreenPos(low);
    ImGui::InvisibleButton("linkings", {width, height});
    mark(state, "linkings");
    const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.45f), full = ImGui::GetColorU32(ImGuiCol_Text),
                accent = ImGui::GetColorU32(ImGuiCol_CheckMark);
    const float middle = low.y + 0.5f * height, x = low.x + width * static_cast<float>(shown) / static_cast<float>(n);
    list.AddLine({low.x, middle}, {low.x + width, middle}, faint, 0.2f * height);
    list.AddLine({low.x, middle}, {x, middle}, full, 0.2f * height);
    if (here)
        list.AddLine({x, middle - 0.42f * height}, {x, middle + 0.42f * height}, accent, 3);
    const int over = std::clamp(1 + static_cast<int>((ImGui::GetMousePos().x - low.x) / width * static_cast<float>(n)), 1, n);
    const auto &linkings = *state.active_solution()->linkings;
    tooltip("Link " + std::to_string(over) + " of " + std::to_string(n), linkings[static_cast<std::size_t>(over - 1)].sentence);
    if (ImGui::IsItemActive() && here != over) {
        state.playing = false;
        show_linkings(state, over);
    }
}

/// The refinement at which we stand, event by event.
void draw_refinement(AppState &state, const ImVec2 &low, float width, float height) {
    const int n = n_splits(state), m = n_linkings(state);
    if (n + m == 0)
        return;
    const auto of = [](int k, int all) { return std::to_string(k) + " of " + std::to_string(all); };
    const std::string splits = count_words(n) + (n == 1 ? " split" : " splits"), links = count_words(m) + (m == 1 ? " link" : " links");
    const std::string text = shown_splits(state)     ? "split " + of(*shown_splits(state), n)
                             : shown_linkings(state) ? "link " + of(*shown_linkings(state), m)
                             : n == 0                ? links
                             : m == 0                ? splits
                                                     : splits + ", " + links;
    const float size = 0.85f * em(), label = em(12), gap = n > 0 && m > 0 ? em() : 0;
    ImGui::GetWindowDrawList()->AddText(nullptr, size, {low.x, low.y + 0.5f * (height - size)}, ImGui::GetColorU32(ImGuiCol_Text),
                                        ("refine \u00b7 " + text).c_str());
    const float left = low.x + label, room = width - label - gap;
    const float ticks = n == 0 ? 0 : m == 0 ? room : std::min(0.6f * room, em(1.1f) * static_cast<float>(n));
    if (n > 0)
        draw_splits(state, {left, low.y}, ticks, height);
    if (m > 0)
        draw_linkings(state, {left + ticks + gap, low.y}, std::min(room - ticks, em(14)), height);
}

/// The course as a line of beads, three to an iteration: filled as far as computed, ringed where we stand. A click
/// goes there, and so does a drag as far as is computed.
void draw_course(AppState &state, float width) {
    const int last = state.timeline(state.active_strategy()).last();
    const int n = std::max(last + 1, 4 * phases_per_iteration);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = em(1.7f), r = 0.24f * em();
    const float step = std::min(em(2.6f), (width - 4 * r) / static_cast<float>(n));
    ImGui::InvisibleButton("course", {std::max(width, 1.f), height});
    mark(state, "course");
    ImDrawList &list = *ImGui::GetWindowDrawList();
    const auto x_of = [&](int p) { return low.x + 2 * r + step * static_cast<float>(p); };
    const float y = low.y + 0.36f * height;
    const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.45f), full = ImGui::GetColorU32(ImGuiCol_Text),
                accent = ImGui::GetColorU32(ImGuiCol_CheckMark);
    list.AddLine({x_of(0), y}, {x_of(n), y}, faint);
    if (last > 0)
        list.AddLine({x_of(0), y}, {x_of(last), y}, full);
    for (int p = 0; p <= n; ++p) {
        const bool whole = p % phases_per_iteration == 0;
        const float radius = std::min(whole ? r : 0.6f * r, 0.45f * step);
        list.AddCircleFilled({x_of(p), y}, radius, p <= last ? full : faint);
        const int every = std::max(1, static_cast<int>(std::ceil(em(1.2f) / (3 * step))));
        if (whole && p / phases_per_iteration % every == 0) {
            const std::string number = std::to_string(p / phases_per_iteration);
            list.AddText(nullptr, 0.75f * em(), {x_of(p) - 0.2f * em() * static_cast<float>(number.size()), y + 1.6f * r},
                         faint, number.c_str());
        }
    }
    const int here = state.shown_position();
    list.AddCircleFilled({x_of(here), y}, 1.15f * r, accent);
    list.AddCircle({x_of(here), y}, 1.8f * r, accent, 0, 1.5f);
    if (!ImGui::IsItemHovered())
        return;
    const int over = std::clamp(static_cast<int>(std::lround((ImGui::GetMousePos().x - x_of(0)) / step)), 0, n);
    tooltip(position_words(over), over <= last ? "Computed; a click or a drag goes there." : "A click solves up to here.");
    const bool dragged = ImGui::IsItemActive() && over <= last && over != state.position;
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) || dragged) {
        state.playing = false;
        go_to(state, over);
    }
}

void draw_work(AppState &state) {
    if (state.busy) {
        const double since = std::chrono::duration<double>(Clock::now() - state.busy->since).count();
        icon_button(state, "solve.cancel", Icon::stop, em(1.9f));
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::Text("%s (%s)  %.1f s", phase_verb(state.busy->position).c_str(), letter(state.busy->strategy), since);
        return;
    }
    float speed = static_cast<float>(state.phases_per_second);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.5f * (em(1.9f) - ImGui::GetFrameHeight()));
    ImGui::SetNextItemWidth(-1);
    if (ImGui::SliderFloat("##speed", &speed, static_cast<float>(slowest_play), static_cast<float>(fastest_play), "%.3g steps/s",
                           ImGuiSliderFlags_Logarithmic))
        set_speed(state, static_cast<double>(speed));
    mark(state, "speed");
    tooltip("Speed of playing", "How many phases, and splits within them, are shown in a second, at most.", ",  .");
}

} // namespace

void draw_transport(AppState &state, const WindowRect &rect) {
    begin_panel("transport", rect);
    if (is_narrow(rect.width, em())) {
        ImGui::SetCursorPosY(em(0.6f));
        draw_buttons(state);
        ImGui::SameLine(0, em(1));
        draw_work(state);
        const ImVec2 below(ImGui::GetWindowPos().x + ImGui::GetStyle().WindowPadding.x, rect.y + em(3));
        ImGui::SetCursorScreenPos(below);
        const float whole = ImGui::GetContentRegionAvail().x;
        draw_course(state, whole);
        draw_refinement(state, {below.x, below.y + em(1.8f)}, whole, em(1.1f));
        ImGui::End();
        return;
    }
    ImGui::SetCursorPosY(0.5f * (rect.height - em(1.9f)));
    draw_buttons(state);
    ImGui::SameLine(0, em(1.2f));
    const float right = em(14), here = ImGui::GetCursorPosX();
    const float width = std::max(em(4), ImGui::GetWindowContentRegionMax().x - here - right - em(1));
    const ImVec2 corner(ImGui::GetCursorScreenPos().x, rect.y + 0.3f * em());
    ImGui::SetCursorScreenPos(corner);
    draw_course(state, width);
    draw_refinement(state, {corner.x, corner.y + em(1.8f)}, width, em(1.1f));
    ImGui::SetCursorPos({here + width + em(1), 0.5f * (rect.height - em(1.9f))});
    draw_work(state);
    ImGui::End();
}

} // namespace penumbra
