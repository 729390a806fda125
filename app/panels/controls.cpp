#include "panels/controls.h"

#include "core/check.h"
#include "panels/shortened.h"
#include "paper_lines.h"

#include <algorithm>

namespace penumbra {

namespace {

const Action &known(std::string_view id) {
    const Action *action = find_action(id);
    PENUMBRA_CHECK(action != nullptr, ==, true);
    return *action;
}

void tooltip_of(const Action &action) {
    tooltip(std::string(action.title), action.help, action.keys.empty() ? std::string_view{} : action.keys.front(),
            action.paper);
}

void push_on_colours(bool on) {
    if (!on)
        return;
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
}
void pop_on_colours(bool on) {
    if (on)
        ImGui::PopStyleColor(2);
}

/// Buttons may be made narrower than their text, which is cut then.
void note_cut_text(AppState &state, std::string_view name, const char *text) {
    if (ImGui::CalcTextSize(text).x + ImGui::GetStyle().FramePadding.x > ImGui::GetItemRectSize().x + 1)
        state.cut.push_back("text of " + std::string(name));
}

void draw_icon(ImDrawList &list, Icon icon, ImVec2 centre, float r, ImU32 colour) {
    const auto triangle = [&](float x, float direction) {
        const float w = 0.8f * r * direction;
        list.AddTriangleFilled({x - 0.55f * w, centre.y - r}, {x + w, centre.y}, {x - 0.55f * w, centre.y + r}, colour);
    };
    const auto bar = [&](float x) {
        list.AddRectFilled({x - 0.15f * r, centre.y - 0.95f * r}, {x + 0.15f * r, centre.y + 0.95f * r}, colour);
    };
    switch (icon) {
    case Icon::play:
        triangle(centre.x - 0.2f * r, 1.7f);
        break;
    case Icon::pause:
        list.AddRectFilled({centre.x - 0.8f * r, centre.y - r}, {centre.x - 0.25f * r, centre.y + r}, colour);
        list.AddRectFilled({centre.x + 0.25f * r, centre.y - r}, {centre.x + 0.8f * r, centre.y + r}, colour);
        break;
    case Icon::forward:
        triangle(centre.x - 0.35f * r, 1);
        bar(centre.x + 0.75f * r);
        break;
    case Icon::back:
        triangle(centre.x + 0.35f * r, -1);
        bar(centre.x - 0.75f * r);
        break;
    case Icon::to_start:
        triangle(centre.x + 0.9f * r, -1);
        triangle(centre.x - 0.05f * r, -1);
        bar(centre.x - 1.05f * r);
        break;
    case Icon::to_end:
        triangle(centre.x - 0.9f * r, 1);
        triangle(centre.x + 0.05f * r, 1);
        bar(centre.x + 1.05f * r);
        break;
    case Icon::stop:
        list.AddRectFilled({centre.x - 0.8f * r, centre.y - 0.8f * r}, {centre.x + 0.8f * r, centre.y + 0.8f * r},
                           colour);
        break;
    }
}

} // namespace

float em(float n) { return n * ImGui::GetFontSize(); }

void mark(AppState &state, std::string_view name) {
    const ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    state.widgets[std::string(name)] = {low.x, low.y, size.x, size.y};
    state.marked = name;
}

void note_told(const std::string &title, std::string_view sentence, const std::string &paper) {
    AppState &state = *static_cast<AppState *>(ImGui::GetIO().UserData);
    state.told = {state.marked, title, std::string(sentence), paper};
}

void tooltip(const std::string &title, std::string_view sentence, std::string_view key, const std::string &paper) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        return;
    note_told(title, sentence, paper);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(em(22));
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", title.c_str());
    if (!key.empty()) {
        ImGui::SameLine();
        ImGui::TextDisabled("%.*s", static_cast<int>(key.size()), key.data());
    }
    ImGui::TextUnformatted(sentence.data(), sentence.data() + sentence.size());
    if (!paper.empty())
        ImGui::TextDisabled("%s", paper.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void text_that_fits(AppState &state, const std::string &whole, float width, const char *name, const char *title) {
    const std::string shown = shortened(whole, width);
    ImGui::TextUnformatted(shown.c_str());
    if (shown == whole)
        return;
    mark(state, name);
    tooltip(title, whole);
}

void action_button(AppState &state, std::string_view id, const char *text, ImVec2 size) {
    const Action &action = known(id);
    const bool on = is_checked(action, state);
    const std::string label = (text ? std::string(text) : std::string(action.title)) + "##" + std::string(id);
    push_on_colours(on);
    ImGui::BeginDisabled(!is_enabled(action, state));
    const bool clicked = ImGui::Button(label.c_str(), size);
    ImGui::EndDisabled();
    pop_on_colours(on);
    mark(state, id);
    note_cut_text(state, id, text ? text : std::string(action.title).c_str());
    tooltip_of(action);
    if (clicked)
        run(action, state);
}

void held_button(AppState &state, std::string_view id, const char *text, bool &held, ImVec2 size) {
    const Action &action = known(id);
    const bool on = held;
    push_on_colours(on);
    ImGui::BeginDisabled(!is_enabled(action, state));
    ImGui::Button((std::string(text) + "##" + std::string(id)).c_str(), size);
    held = ImGui::IsItemActive() && is_enabled(action, state) && !state.inert;
    ImGui::EndDisabled();
    pop_on_colours(on);
    mark(state, id);
    note_cut_text(state, id, text);
    tooltip_of(action);
}

void icon_button(AppState &state, std::string_view id, Icon icon, float size) {
    const Action &action = known(id);
    const bool enabled = is_enabled(action, state), on = is_checked(action, state);
    push_on_colours(on);
    ImGui::BeginDisabled(!enabled);
    const bool clicked = ImGui::Button(("##" + std::string(id)).c_str(), {1.35f * size, size});
    ImGui::EndDisabled();
    pop_on_colours(on);
    mark(state, id);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    draw_icon(*ImGui::GetWindowDrawList(), icon, {0.5f * (low.x + high.x), 0.5f * (low.y + high.y)}, 0.22f * size,
              ImGui::GetColorU32(enabled ? ImGuiCol_Text : ImGuiCol_TextDisabled));
    tooltip_of(action);
    if (clicked)
        run(action, state);
}

void action_check(AppState &state, std::string_view id, const char *text) {
    const Action &action = known(id);
    bool on = is_checked(action, state);
    const std::string label = (text ? std::string(text) : std::string(action.title)) + "##" + std::string(id);
    ImGui::BeginDisabled(!is_enabled(action, state));
    const bool clicked = ImGui::Checkbox(label.c_str(), &on);
    ImGui::EndDisabled();
    mark(state, id);
    tooltip_of(action);
    if (clicked)
        run(action, state);
}

bool choice(AppState &state, std::string_view name, const char *text, bool on, const char *sentence, ImVec2 size) {
    push_on_colours(on);
    const bool clicked = ImGui::Button((std::string(text) + "##" + std::string(name)).c_str(), size);
    pop_on_colours(on);
    mark(state, name);
    note_cut_text(state, name, text);
    tooltip(text, sentence, {}, paper_line(name));
    return clicked;
}

float button_width(const char *text) { return ImGui::CalcTextSize(text).x + 2 * ImGui::GetStyle().FramePadding.x; }

bool go_on(float space, float width) {
    ImGui::SameLine(0, space);
    if (ImGui::GetCursorPosX() + width <= ImGui::GetWindowContentRegionMax().x)
        return false;
    ImGui::NewLine();
    return true;
}

ButtonRow::ButtonRow(const std::vector<const char *> &texts) {
    const float left = ImGui::GetContentRegionAvail().x, least = 1.2f * ImGui::GetStyle().FramePadding.x;
    std::size_t begin = 0;
    float taken = 0; // by the texts of a line
    const auto fill = [&](std::size_t end) {
        const auto n = static_cast<float>(end - begin);
        for (std::size_t i = begin; i < end; ++i)
            places_[i].width += (left - (n - 1) - taken) / n;
        begin = end;
        taken = 0;
    };
    for (const char *text : texts) {
        const float width = ImGui::CalcTextSize(text).x, n = static_cast<float>(places_.size() - begin) + 1;
        const bool breaks = n > 1 && taken + width + n * least + n - 1 > left;
        if (breaks)
            fill(places_.size());
        places_.push_back({width, breaks || places_.empty()});
        taken += width;
    }
    fill(places_.size());
}

ImVec2 ButtonRow::next() {
    const Place place = places_[next_++];
    if (!place.begins_line)
        ImGui::SameLine(0, 1);
    return {place.width, 0};
}

void heading(const char *text) {
    ImGui::Dummy({0, em(0.25f)});
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void figure(const char *name, const std::string &value, const char *sentence) {
    ImGui::BeginGroup();
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine();
    const float at = ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x;
    if (at < ImGui::GetCursorPosX())
        ImGui::NewLine(); // too long to stand beside its name
    ImGui::SetCursorPosX(at);
    ImGui::TextUnformatted(value.c_str());
    ImGui::EndGroup();
    if (!sentence)
        return;
    const std::string control = std::string("figure ") + name;
    mark(*static_cast<AppState *>(ImGui::GetIO().UserData), control);
    tooltip(name, sentence, {}, paper_line(control));
}

void field_label(const char *text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", text);
    ImGui::SameLine(em(6.2f));
    ImGui::SetNextItemWidth(-1);
}

ImGuiWindowFlags panel_flags() {
    return ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
           ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
           ImGuiWindowFlags_NoNavInputs;
}

void begin_card(const char *name) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, em(0.3f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {em(0.9f), em(0.7f)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
}

void end_card() {
    ImGui::End();
    ImGui::PopStyleVar(3);
}

void begin_panel(const char *name, const WindowRect &rect) {
    ImGui::SetNextWindowPos({rect.x, rect.y});
    ImGui::SetNextWindowSize({rect.width, rect.height});
    const bool bar = rect.height < em(4); // a bar that is one line high never scrolls
    ImGui::Begin(name, nullptr,
                 panel_flags() | (bar ? ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse : 0));
}

} // namespace penumbra
