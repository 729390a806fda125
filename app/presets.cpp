#include "presets.h"

#include "pane_verbs.h"
#include "verbs.h"

namespace penumbra {

namespace {

constexpr double lecture_scale = 1.5;

/// The present strategy stays the active pane's.
void begin(AppState &state, Layout layout, bool panels, double scale, Theme theme, bool links) {
    const Strategy now = state.active_strategy();
    if (state.has_own_cameras()) // panes are to be compared
        toggle_cameras(state);
    if (state.has_own_tones())
        toggle_tones(state);
    if (state.has_own_steps())
        toggle_steps(state);
    set_layout(state, layout);
    if (layout == Layout::single)
        state.panes().strategies[0] = now;
    state.panels_hidden = !panels;
    state.ui_scale = scale;
    state.look.theme = theme;
    state.look.layers = {true, true, links};
    state.look.change.reset();
    state.legend_hidden = false;
    state.inspector = Inspector::none;
}

} // namespace

void preset_lecture(AppState &state) {
    begin(state, Layout::single, false, lecture_scale, Theme::dark, false);
    state.message = {"Lecture: F11 brings the panels back.", false};
}

void preset_compare(AppState &state) {
    const bool constant = is_constant(state.active_strategy());
    begin(state, Layout::two, true, 1, state.look.theme, false);
    state.panes() = {{strategy_of(false, constant), strategy_of(true, constant)}, 1};
    state.chosen_range = state.look.range;
    state.message = {"Compare: the range of colours stays as it is now.", false};
}

void preset_inspect(AppState &state) {
    begin(state, Layout::single, true, 1, state.look.theme, true);
    state.inspector = Inspector::element;
    state.message = {"Inspect: click a patch.", false};
}

void preset_figure(AppState &state) {
    begin(state, Layout::four, false, 1, Theme::light, false);
    state.panes().strategies = {Strategy::uniform_constant, Strategy::discontinuity_constant, Strategy::uniform_wavelet,
                                Strategy::discontinuity_wavelet};
    state.message = {"Figure: F12 saves it; F11 brings the panels back.", false};
}

} // namespace penumbra
