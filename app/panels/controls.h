// The few controls that all panels are made of, so that they look alike, tell their key and sentence, and can be found
// by name.
#pragma once

#include "action.h"
#include "app_state.h"

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

enum class Icon { to_start, back, play, pause, forward, to_end, stop };

/// Remembers where the last item was drawn.
void mark(AppState &state, std::string_view name);

/// A button that does the action; grey when it is disabled, filled when it is checked. `text` replaces the title.
/// Hovering tells title, sentence and key.
void action_button(AppState &state, std::string_view id, const char *text = nullptr, ImVec2 size = {0, 0});
/// For an action that lasts as long as its button is held: says in `held` whether it is.
void held_button(AppState &state, std::string_view id, const char *text, bool &held, ImVec2 size = {0, 0});
void icon_button(AppState &state, std::string_view id, Icon icon, float size);
/// A check box for an action that is a toggle.
void action_check(AppState &state, std::string_view id, const char *text = nullptr);

/// A button of a group of which one is on. Returns whether it was clicked.
bool choice(AppState &state, std::string_view name, const char *text, bool on, const char *tooltip, ImVec2 size = {0, 0});

/// Buttons side by side over what is left of the line, each as wide as its text asks; in more lines where they would be cut.
class ButtonRow {
public:
    explicit ButtonRow(const std::vector<const char *> &texts);
    /// Of the next button, which is to be drawn right after.
    ImVec2 next();

private:
    struct Place {
        float width = 0;
        bool begins_line = false;
    };
    std::vector<Place> places_;
    std::size_t next_ = 0;
};
/// What is drawn next, so wide, goes on in this line after a space, or in the next one where it would be cut. Returns whether
/// that is a new line.
bool go_on(float space, float width);
/// Of a button with this text.
float button_width(const char *text);

/// A small heading, with space above.
void heading(const char *text);
/// "patches        262": name on the left, value on the right of the present width. Marked as "figure NAME".
void figure(const char *name, const std::string &value, const char *tooltip = nullptr);
/// A name on the left; the next item takes the rest of the line.
void field_label(const char *text);
/// What the mouse tells about the last item: title and key, a plain sentence, and what the paper calls it (paper_lines.h).
void tooltip(const std::string &title, std::string_view sentence, std::string_view key = {}, const std::string &paper = {});
/// As much of the text as fits; where that is not all, the mouse tells the whole of it, under this name and title.
void text_that_fits(AppState &state, const std::string &whole, float width, const char *name, const char *title);
/// Notes that the last item, which is hovered, tells this in a tooltip of its own.
void note_told(const std::string &title, std::string_view sentence, const std::string &paper = {});

/// Text heights; every distance is a multiple.
float em(float n = 1);

/// Flags of a panel that is fixed in its place.
ImGuiWindowFlags panel_flags();
/// A card over the panes, where ImGui's next window was put; it takes no focus. End with end_card().
void begin_card(const char *name);
void end_card();
/// Begins a panel that fills the rectangle; end with ImGui::End().
void begin_panel(const char *name, const WindowRect &rect);

} // namespace penumbra
