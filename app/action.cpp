#include "action.h"

#include "bookmark_verbs.h"
#include "effect_verbs.h"
#include "files/settings.h"
#include "history.h"
#include "keyhole_verbs.h"
#include "microscope_verbs.h"
#include "move_verbs.h"
#include "picture_verbs.h"
#include "presets.h"
#include "orphan_verbs.h"
#include "paper_lines.h"
#include "profile_verbs.h"
#include "render/error_scale.h"
#include "shelf_verbs.h"
#include "split_verbs.h"
#include "tour.h"
#include "truth_verbs.h"
#include "verbs.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace penumbra {

namespace {

using State = AppState;

bool has_scene(const State &s) { return s.scene != nullptr; }
bool has_solution(const State &s) { return has_scene(s) && s.snapshot(s.active_strategy()); }
bool can_go_on(const State &s) { return has_scene(s) && !at_end(s); }
bool can_go_back(const State &s) { return s.position > 0; }
/// Between two phases the worker is not busy for a moment, but has its goal still before it.
bool is_under_way(const State &s) {
    return has_scene(s) && !s.halted &&
           std::ranges::any_of(s.shown(), [&](Strategy strategy) { return !s.timeline(strategy).reached(s.position); });
}
bool can_cancel(const State &s) { return s.busy || s.playing || !s.opening.empty() || is_under_way(s); }

template <Strategy strategy>
void use_strategy(State &s) {
    set_strategy(s, strategy);
}
template <Strategy strategy>
bool uses_strategy(const State &s) {
    return s.active_strategy() == strategy;
}
template <Layout layout>
void use_layout(State &s) {
    set_layout(s, layout);
}
template <Layout layout>
bool uses_layout(const State &s) {
    return s.layout == layout;
}
template <Inspector inspector>
void use_inspector(State &s) {
    toggle_inspector(s, inspector);
}
template <Inspector inspector>
bool uses_inspector(const State &s) {
    return s.inspector == inspector;
}
template <Shading shading>
void use_shading(State &s) {
    s.look.shading = shading;
    s.look.change.reset();
}
template <Shading shading>
bool uses_shading(const State &s) {
    return s.look.shading == shading;
}

template <ErrorKind kind>
void use_error(State &s) {
    show_errors(s, kind);
}
template <ErrorKind kind>
bool uses_error(const State &s) {
    return s.look.shading == Shading::error && s.look.error == kind;
}
bool shows_errors(const State &s) { return s.look.shading == Shading::error; }

void flip_errors(State &s) {
    if (shows_errors(s))
        use_shading<Shading::polynomial>(s);
    else
        show_errors(s, s.look.error);
}
void next_error(State &s) {
    constexpr int n = static_cast<int>(std::size(all_error_kinds));
    show_errors(s, shows_errors(s) ? static_cast<ErrorKind>((static_cast<int>(s.look.error) + 1) % n) : s.look.error);
}

void flip_meshing(State &s) {
    const Strategy now = s.active_strategy();
    set_strategy(s, strategy_of(!cuts_along_curves(now), is_constant(now)));
}
void flip_basis(State &s) {
    const Strategy now = s.active_strategy();
    set_strategy(s, strategy_of(cuts_along_curves(now), !is_constant(now)));
}

void next_shading(State &s) {
    constexpr Shading next[] = {Shading::flat, Shading::linear, Shading::polynomial, Shading::polynomial};
    s.look.shading = next[static_cast<std::size_t>(s.look.shading)];
    s.look.change.reset();
}

void next_layout(State &s) { set_layout(s, static_cast<Layout>((static_cast<std::size_t>(s.layout) + 1) % n_layouts)); }

bool range_is_locked(const State &s) { return shows_errors(s) ? s.truth.range_locked : s.chosen_range.has_value(); }
/// Of the errors, where these are shown, else of the radiosity.
void flip_range_lock(State &s) {
    if (shows_errors(s)) {
        toggle_range_lock(s);
        return;
    }
    s.chosen_range = s.chosen_range ? std::nullopt : s.look.range;
    s.message = {s.chosen_range ? "The range of colours stays as it is." : "The range of colours follows what is shown.", false};
}

void change_exposure(State &s, double ev) {
    s.look.exposure_ev = std::clamp(s.look.exposure_ev + ev, -10.0, 10.0);
}

/// Esc leaves what is open, one thing at a time, before it stops the solver.
void cancel(State &s) {
    if (s.palette.open) {
        s.palette = {};
    } else if (s.script.playing) {
        s.script.playing = false;
        s.message = {"The script was stopped at its line " + std::to_string(s.script.line) + ".", false};
    } else if (s.help_open || s.open_dialog || s.pictures.settings_open) {
        s.help_open = s.open_dialog = s.pictures.settings_open = false;
    } else if (!s.pictures.pending.empty()) {
        drop_pictures(s);
    } else if (s.pinned_curve) {
        s.pinned_curve.reset();
    } else if (s.keyhole.open) {
        s.keyhole.open = false;
    } else if (s.truth.busy) {
        stop_judging(s);
    } else if (s.profile.open) {
        toggle_profile(s);
    } else if (s.shelf.checking) {
        stop_check(s);
    } else if (s.inspector != Inspector::none && !can_cancel(s)) {
        s.inspector = Inspector::none;
    } else if (can_cancel(s)) {
        s.cancel_request = true;
        s.halted = true;
        s.seeking = false;
        s.playing = false;
    } else if (s.tour.open) {
        s.tour.open = false;
    } else {
        s.message = {};
    }
}

void scale(State &s, double factor) { s.ui_scale = std::clamp(s.ui_scale * factor, smallest_ui_scale, largest_ui_scale); }

void hide_panels(State &s) {
    s.panels_hidden = !s.panels_hidden;
    s.before_by_mouse = false; // its button is gone
}

void reset(State &s) {
    s.playing = false;
    go_to(s, 0);
    s.message = {"Back at the start.", false};
}

void toggle_play(State &s) {
    s.playing = !s.playing;
    if (s.playing) {
        s.halted = false;
        s.hint_done = true;
    } else {
        s.message = {"Paused.", false};
    }
}

template <int to(int)>
void go(State &s) {
    s.playing = false;
    go_to(s, to(s.position));
}
constexpr int next_phase(int p) { return p + 1; }
constexpr int previous_phase(int p) { return p - 1; }
constexpr int to_the_end(int) { return far_ahead; }

std::vector<Action> with_paper_lines(std::vector<Action> all) {
    for (Action &action : all)
        action.paper = paper_line(action.id);
    return all;
}

template <void move(State &)>
void pause_and(State &s) {
    s.playing = false;
    move(s);
}
bool can_go_on_by_splits(const State &s) {
    return can_go_on(s) || shown_splits(s).value_or(n_splits(s)) < n_splits(s);
}
template <int halvings>
void change_speed(State &s) {
    set_speed(s, std::ldexp(s.phases_per_second, halvings));
}
void toggle_animation(State &s) {
    s.animates_splits = !s.animates_splits;
    s.message = {s.animates_splits ? "Playing shows the splits of a refinement one by one."
                                   : "Playing shows the splits of a refinement all at once.",
                 false};
}

const std::vector<Action> &list() {
    static const std::vector<Action> all = with_paper_lines({
        {"file.open", Menu::file, "Open…",
         "Opens a scene, a saved state or a picture; a file may also be dropped on the window.", {"Ctrl+O"},
         [](State &s) { s.open_dialog = !s.open_dialog; }},
        {"file.state", Menu::file, "Save state", "Saves scene, options, step and view, to be opened again.", {"Ctrl+S"},
         [](State &s) { s.state_request = true; }, has_scene},
        {"file.picture", Menu::file, "Save picture", "Saves the panes with their labels and legend as a numbered PNG.",
         {"F12"}, [](State &s) { s.picture_request = PictureRequest::panes; }, has_scene},
        {"file.window_picture", Menu::file, "Save picture of the window", "Saves the whole window as a numbered PNG.",
         {"Ctrl+F12"}, [](State &s) { s.picture_request = PictureRequest::window; }},
        {"file.compare_picture", Menu::file, "Picture of uniform against discontinuity meshing",
         "Both side by side in the active pane's basis, at this step; what is missing is solved first.", {"Shift+F12"},
         compare_meshings, has_solution},
        {"file.sequence", Menu::file, "Pictures of all steps",
         "A numbered PNG of each step from the start to this one, in a new folder.", {"Ctrl+Shift+F12"},
         picture_all_steps, has_solution},
        {"file.picture_settings", Menu::file, "Picture settings…",
         "Size up to 8K, supersampling, transparent background, labels: of all pictures but the window's.", {},
         [](State &s) { s.pictures.settings_open = !s.pictures.settings_open; }},
        {"file.copy_command", Menu::file, "Copy as command",
         "Copies the 'penumbra render' line that makes the picture which Save picture would save.", {"Ctrl+Shift+C"},
         [](State &s) { s.picture_request = PictureRequest::command; }, has_solution},
        {"file.restore", Menu::file, "Restore what was shown", "Opens what a window showed that ended unexpectedly.", {},
         restore_orphan, has_orphan, nullptr, nullptr, true},
        {"file.discard", Menu::file, "Discard what was shown",
         "Deletes what was kept of a window that ended unexpectedly.", {}, discard_orphan, has_orphan, nullptr, nullptr, true},
        {"file.quit", Menu::file, "Quit", "Closes the window.", {"Ctrl+Q"}, [](State &s) { s.quit_request = true; }},

        {"edit.undo", Menu::edit, "Undo", "Takes back the last change of a parameter or of the view.", {"Ctrl+Z"}, undo, can_undo},
        {"edit.redo", Menu::edit, "Redo", "Does again what was undone.", {"Ctrl+Y", "Ctrl+Shift+Z"}, redo, can_redo},
        {"edit.copy_view", Menu::edit, "Copy view", "The eye, its target and the angle, as text that --view takes.", {"Ctrl+C"},
         [](State &s) {
             s.copy_request = view_text(s.camera);
             s.message = {"Copied: " + *s.copy_request, false};
         },
         has_scene},
        {"edit.paste_view", Menu::edit, "Paste view", "Looks as the view in the clipboard does.", {"Ctrl+V"},
         [](State &s) { s.paste_request = true; }, has_scene},
        {"edit.put_back", Menu::edit, "Put objects back", "Everything that was moved goes where the file has it.", {"Shift+O"},
         put_objects_back, [](const State &s) { return !s.objects.moves.empty(); }},
        {"edit.palette", Menu::edit, "Find an action…", "Everything that can be done, found by typing a part of its name.",
         {"Ctrl+K"}, [](State &s) { s.palette = {!s.palette.open, {}, 0}; }, nullptr,
         [](const State &s) { return s.palette.open; }},

        {"solve.play", Menu::solve, "Play / pause", "Goes on by itself, a phase at a time, until converged.", {"Space"},
         toggle_play, has_scene, [](const State &s) { return s.playing; }},
        {"solve.step", Menu::solve, "Step", "One iteration: refine, gather, push and pull.", {"Right"},
         go<step_forward>, can_go_on},
        {"solve.sub_step", Menu::solve, "Next phase", "One phase alone: refine, or gather, or push and pull.",
         {"Shift+Right"}, go<next_phase>, can_go_on},
        {"solve.back", Menu::solve, "Back", "To the end of the iteration before.", {"Left"}, go<step_back>,
         can_go_back},
        {"solve.sub_back", Menu::solve, "Previous phase", "One phase back.", {"Shift+Left"}, go<previous_phase>,
         can_go_back},
        {"solve.split", Menu::solve, "Next split", "One split alone; where a refinement has no more, the next phase.",
         {"Ctrl+Right"}, pause_and<next_split>, can_go_on_by_splits},
        {"solve.split_back", Menu::solve, "Previous split", "One split back; before the first one, one phase.",
         {"Ctrl+Left"}, pause_and<previous_split>, can_go_back},
        {"solve.next_cut", Menu::solve, "To the next cut", "Goes on until an element was cut along a discontinuity curve.",
         {"Ctrl+Shift+Right"}, seek_cut, can_go_on_by_splits},
        {"solve.animate", Menu::solve, "Animate splits", "Playing shows the splits of each refinement one by one.",
         {"J"}, toggle_animation, nullptr, [](const State &s) { return s.animates_splits; }},
        {"solve.slower", Menu::solve, "Slower", "Halves the speed of playing.", {","}, change_speed<-1>,
         [](const State &s) { return s.phases_per_second > slowest_play; }},
        {"solve.faster", Menu::solve, "Faster", "Doubles the speed of playing.", {"."}, change_speed<1>,
         [](const State &s) { return s.phases_per_second < fastest_play; }},
        {"solve.reset", Menu::solve, "Reset", "Back to the start.", {"Home"}, reset, can_go_back},
        {"solve.end", Menu::solve, "To the end", "Iterates until nothing changes any more.", {"End"}, go<to_the_end>,
         can_go_on},
        {"solve.cancel", Menu::solve, "Cancel", "Stops the solver; the last complete state stays.", {"Escape"}, cancel},

        {"check.all", Menu::solve, "Check the hard cases", "Solves every case of the shelf in both bases and measures it.",
         {"Shift+H"}, check_shelf, [](const State &s) { return !s.shelf.checking; }},
        {"check.stop", Menu::solve, "Stop checking", "What has been measured stays.", {}, stop_check,
         [](const State &s) { return s.shelf.checking; }},

        {"effects.by_scene", Menu::solve, "What the scene calls for", "Leaves every effect's switch to the scene; starts anew.",
         {}, decide_by_scene, [](const State &s) { return has_scene(s) && !all_by_scene(s); }},

        {"strategy.a", Menu::strategy, "(a) Uniform meshing, constant basis",
         "Splits in four where the fit is poor; one value a patch.", {"1"}, use_strategy<Strategy::uniform_constant>,
         nullptr, uses_strategy<Strategy::uniform_constant>},
        {"strategy.b", Menu::strategy, "(b) Discontinuity meshing, constant basis",
         "Cuts along shadow boundaries; one value a patch.", {"2"}, use_strategy<Strategy::discontinuity_constant>,
         nullptr, uses_strategy<Strategy::discontinuity_constant>},
        {"strategy.c", Menu::strategy, "(c) Uniform meshing, multiwavelet basis",
         "Splits in four where the fit is poor; a polynomial on each patch.", {"3"},
         use_strategy<Strategy::uniform_wavelet>, nullptr, uses_strategy<Strategy::uniform_wavelet>},
        {"strategy.d", Menu::strategy, "(d) Discontinuity meshing, multiwavelet basis",
         "Cuts along shadow boundaries; a polynomial on each patch.", {"4"},
         use_strategy<Strategy::discontinuity_wavelet>, nullptr, uses_strategy<Strategy::discontinuity_wavelet>},
        {"strategy.meshing", Menu::strategy, "Discontinuity meshing",
         "Cut along shadow boundaries, or split uniformly.", {"U"}, flip_meshing, nullptr,
         [](const State &s) { return cuts_along_curves(s.active_strategy()); }},
        {"strategy.basis", Menu::strategy, "Multiwavelet basis", "A polynomial on each patch, or one value.", {"Shift+U"},
         flip_basis, nullptr, [](const State &s) { return !is_constant(s.active_strategy()); }},
        {"strategy.reconstructed", Menu::strategy, "Constants as quadratics",
         "Draws (a) or (b) as in 1993: quadratics through what the links bring to nodes of each patch, for the eye alone.",
         {"Q"}, toggle_reconstruction, [](const State &s) { return is_constant(s.active_strategy()); },
         [](const State &s) { return s.reconstructs(s.panes().active); }},

        {"view.single", Menu::view, "One pane", "The active strategy alone.", {"Ctrl+1"}, use_layout<Layout::single>,
         nullptr, uses_layout<Layout::single>},
        {"view.two", Menu::view, "Two panes", "Two strategies side by side, with the same eye and step.", {"Ctrl+2"},
         use_layout<Layout::two>, nullptr, uses_layout<Layout::two>},
        {"view.four", Menu::view, "Four panes", "All four strategies, with the same eye and step.", {"Ctrl+4"},
         use_layout<Layout::four>, nullptr, uses_layout<Layout::four>},
        {"view.next_layout", Menu::view, "Next layout", "One pane, two panes, four panes, and so on.", {"Tab"}, next_layout},
        {"view.lecture", Menu::view, "Preset: lecture", "One pane, large text, mesh and curves, no panels.", {"F5"}, preset_lecture},
        {"view.compare", Menu::view, "Preset: compare",
         "Uniform beside discontinuity meshing in the same basis, on one range that stays.", {"F6"}, preset_compare},
        {"view.inspect", Menu::view, "Preset: inspect", "One pane with mesh, curves and links, and the inspector.", {"F7"},
         preset_inspect},
        {"view.figure", Menu::view, "Preset: figure", "All four strategies on a light background, no panels.", {"F8"}, preset_figure},
        {"view.next_pane", Menu::view, "Next pane", "Makes the next pane the active one.", {"Shift+Tab"},
         [](State &s) { s.panes().active = (s.panes().active + 1) % n_panes(s.layout); },
         [](const State &s) { return s.layout != Layout::single; }},
        {"view.reset", Menu::view, "Reset view", "Back to the eye that the scene began with.", {"R"}, reset_view,
         has_scene},
        {"view.fit", Menu::view, "Fit", "Moves the eye until the whole scene is in the frame.", {"F"}, fit_view,
         has_scene},
        {"view.keyhole", Menu::view, "Keyhole",
         "Shows what a point sees of each light; drag the point over a surface.", {"V"}, toggle_keyhole, has_scene,
         [](const State &s) { return s.keyhole.open; }},
        {"view.profile", Menu::view, "Profile along a line",
         "Plots the radiosity along a line, true and solved, and its slope; drag the line over a surface.", {"S"},
         toggle_profile, has_scene, [](const State &s) { return s.profile.open; }},
        {"view.inspector", Menu::view, "Inspector",
         "Shows what an element holds, how it came about and who lights it, and X-rays a link; click a patch.", {"I"},
         use_inspector<Inspector::element>, has_scene, uses_inspector<Inspector::element>},
        {"view.filters", Menu::view, "Filter microscope",
         "Shows the push and pull filters of the split that made a patch; click one.", {"T"},
         use_inspector<Inspector::filters>, has_scene, uses_inspector<Inspector::filters>},
        {"view.objects", Menu::view, "Move things",
         "Lights, blockers and all else can be dragged, or be given a place and a size; mesh and curves follow.", {"O"},
         use_inspector<Inspector::objects>, has_scene, uses_inspector<Inspector::objects>},
        {"view.bookmark", Menu::view, "Bookmark this view", "Keeps scene, options, step and view, with a caption.", {"Ctrl+B"},
         add_bookmark, has_scene},
        {"view.next_bookmark", Menu::view, "Next bookmark", "Shows the next view that was kept.", {"PageDown"},
         [](State &s) { go_to_bookmark(s, s.bookmark + 1); },
         [](const State &s) { return s.bookmark + 1 < static_cast<int>(s.bookmarks.size()); }},
        {"view.previous_bookmark", Menu::view, "Previous bookmark", "Shows the view that was kept before.", {"PageUp"},
         [](State &s) { go_to_bookmark(s, s.bookmark - 1); }, [](const State &s) { return s.bookmark > 0; }},
        {"view.bookmarks", Menu::view, "Bookmarks", "The views that were kept, to be gone to, captioned or taken away.",
         {"Ctrl+Shift+B"}, use_inspector<Inspector::bookmarks>, nullptr, uses_inspector<Inspector::bookmarks>},
        {"view.hard_cases", Menu::view, "Hard cases", "The shelf of small scenes that are hard to solve, and their checks.",
         {"H"}, use_inspector<Inspector::hard_cases>, nullptr, uses_inspector<Inspector::hard_cases>},
        {"view.cost", Menu::view, "Cost of accuracy",
         "Plots the error against seconds or work as one steps; a click on a point goes back to it.", {"A"},
         use_inspector<Inspector::cost>, has_scene, uses_inspector<Inspector::cost>},
        {"view.effects", Menu::view, "Effects",
         "What the scene calls for, and why; each effect can be switched, and what it changes be shown.", {"Y"},
         use_inspector<Inspector::effects>, has_scene, uses_inspector<Inspector::effects>},
        {"view.brighter", Menu::view, "Brighter", "Exposure up by half a stop, in all panes.", {"E"},
         [](State &s) { change_exposure(s, 0.5); }},
        {"view.darker", Menu::view, "Darker", "Exposure down by half a stop, in all panes.", {"Shift+E"},
         [](State &s) { change_exposure(s, -0.5); }},
        {"view.exposure_0", Menu::view, "Exposure 0 EV", "Exposure back to 0.", {"Ctrl+E"},
         [](State &s) { s.look.exposure_ev = 0; }},
        {"view.panels", Menu::view, "Hide panels", "The scene alone; the same key brings the panels back.", {"F11"},
         hide_panels, nullptr,
         [](const State &s) { return s.panels_hidden; }},
        {"view.theme", Menu::view, "Light background", "For projectors and print.", {"Shift+B"},
         [](State &s) { s.look.theme = s.chosen_theme = s.look.theme == Theme::dark ? Theme::light : Theme::dark; }, nullptr,
         [](const State &s) { return s.look.theme == Theme::light; }},
        {"view.before", Menu::view, "Before", "While it is held down, the panes show what was before the last step.",
         {"B"}, [](State &s) { s.before_by_key = true; }, can_go_back, [](const State &s) { return s.before_by_key; },
         [](State &s) { s.before_by_key = false; }},
        {"view.larger", Menu::view, "Larger text", "Scales the whole interface up.", {"Ctrl++", "Ctrl+="},
         [](State &s) { scale(s, 1.125); }},
        {"view.smaller", Menu::view, "Smaller text", "Scales the whole interface down.", {"Ctrl+-"},
         [](State &s) { scale(s, 1 / 1.125); }},

        {"layers.mesh", Menu::layers, "Mesh", "Sides of the patches.", {"M"},
         [](State &s) { s.look.layers.mesh = !s.look.layers.mesh; }, nullptr,
         [](const State &s) { return s.look.layers.mesh; }},
        {"layers.curves", Menu::layers, "Discontinuity curves", "Where the light or one of its derivatives jumps.",
         {"D"}, [](State &s) { s.look.layers.curves = !s.look.layers.curves; }, nullptr,
         [](const State &s) { return s.look.layers.curves; }},
        {"layers.links", Menu::layers, "Links", "From the centre of each receiving element to its sources.", {"L"},
         [](State &s) { s.look.layers.links = !s.look.layers.links; }, nullptr,
         [](const State &s) { return s.look.layers.links; }},
        {"layers.fresh", Menu::layers, "Highlight new patches", "Outlines for a moment what the last refinement made.",
         {"N"}, [](State &s) { s.look.emphasise_fresh = !s.look.emphasise_fresh; }, nullptr,
         [](const State &s) { return s.look.emphasise_fresh; }},
        {"layers.next_shading", Menu::layers, "Next shading", "Polynomial, flat, linear, and so on.", {"P"}, next_shading},
        {"layers.polynomial", Menu::layers, "Polynomial", "The solution itself, evaluated at every pixel.", {},
         use_shading<Shading::polynomial>, nullptr, uses_shading<Shading::polynomial>},
        {"layers.flat", Menu::layers, "Flat", "The mean of each patch.", {}, use_shading<Shading::flat>, nullptr,
         uses_shading<Shading::flat>},
        {"layers.linear", Menu::layers, "Linear", "Gouraud's interpolation of averaged corner values.", {},
         use_shading<Shading::linear>, nullptr, uses_shading<Shading::linear>},
        {"layers.error", Menu::layers, "Error", "How wrong the solution is, in place of the light.", {"X"}, flip_errors,
         has_scene, shows_errors},
        {"error.next", Menu::layers, "Next kind of error", "Signed, relative, of the patch, against the estimate.",
         {"Shift+X"}, next_error, has_scene},
        {"error.signed", Menu::layers, "Signed error", error_sentence(ErrorKind::signed_error), {},
         use_error<ErrorKind::signed_error>, has_scene, uses_error<ErrorKind::signed_error>},
        {"error.relative", Menu::layers, "Relative error", error_sentence(ErrorKind::relative), {},
         use_error<ErrorKind::relative>, has_scene, uses_error<ErrorKind::relative>},
        {"error.patch", Menu::layers, "Error of each patch", error_sentence(ErrorKind::patch), {},
         use_error<ErrorKind::patch>, has_scene, uses_error<ErrorKind::patch>},
        {"error.estimate", Menu::layers, "Error against the estimate", error_sentence(ErrorKind::estimate), {},
         use_error<ErrorKind::estimate>, has_scene, uses_error<ErrorKind::estimate>},
        {"layers.lock_range", Menu::layers, "Lock the range",
         "Keeps the scale of colours, or of errors, as it is through steps and strategies, so that they can be compared.", {"K"},
         flip_range_lock, has_scene, range_is_locked},
        {"layers.false_colour", Menu::layers, "False colour", "Radiosity on the cividis scale, with its legend.", {"C"},
         [](State &s) { s.look.false_colour = !s.look.false_colour; }, nullptr,
         [](const State &s) { return s.look.false_colour; }},
        {"layers.legend", Menu::layers, "Legend", "Scales and line kinds in the picture.", {"G"},
         [](State &s) { s.legend_hidden = !s.legend_hidden; }, nullptr,
         [](const State &s) { return !s.legend_hidden; }},

        {"help.keys", Menu::help, "Keys and mouse", "Everything that the window answers to.", {"?", "F1"},
         [](State &s) { s.help_open = !s.help_open; }, nullptr, [](const State &s) { return s.help_open; }},
        {"help.tour", Menu::help, "Tour", "Six cards on what there is to see; each can show it.", {"Shift+F1"}, toggle_tour,
         nullptr, [](const State &s) { return s.tour.open; }},
    });
    return all;
}

} // namespace

std::string_view title(Menu menu) {
    constexpr std::string_view titles[] = {"File", "Edit", "Solve", "Strategy", "View", "Layers", "Help"};
    return titles[static_cast<std::size_t>(menu)];
}

std::span<const Action> actions() { return list(); }

const Action *find_action(std::string_view id) {
    const auto found = std::ranges::find(list(), id, &Action::id);
    return found == list().end() ? nullptr : &*found;
}

const Action *action_on_key(std::string_view key) {
    for (const Action &a : list())
        if (std::ranges::find(a.keys, key) != a.keys.end())
            return &a;
    return nullptr;
}

void release_key(std::string_view key, AppState &state) {
    for (const Action &a : list())
        if (a.release && std::ranges::any_of(a.keys, [&](std::string_view k) { return k.substr(k.rfind('+') + 1) == key; }))
            a.release(state);
}

bool is_enabled(const Action &action, const AppState &state) { return !action.enabled || action.enabled(state); }

bool is_checked(const Action &action, const AppState &state) { return action.checked && action.checked(state); }

void choose(const Action &action, AppState &state) {
    if (action.release && is_checked(action, state))
        action.release(state);
    else
        run(action, state);
}

bool is_offered(const Action &action, const AppState &state) { return !action.passing || is_enabled(action, state); }

bool run(const Action &action, AppState &state) {
    if (state.inert || !is_enabled(action, state))
        return false;
    if (state.message.error)
        state.message = {};
    action.run(state);
    return true;
}

} // namespace penumbra
