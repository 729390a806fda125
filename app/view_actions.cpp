#include "menu_actions.h"

#include "bookmark_verbs.h"
#include "files/settings.h"
#include "keyhole_verbs.h"
#include "microscope_verbs.h"
#include "pane_verbs.h"
#include "presets.h"
#include "profile_verbs.h"
#include "verbs.h"

#include <algorithm>

namespace penumbra {

namespace {

template <Layout layout>
void use_layout(AppState &s) {
    set_layout(s, layout);
}
template <Layout layout>
bool uses_layout(const AppState &s) {
    return s.layout == layout;
}
template <Inspector inspector>
void use_inspector(AppState &s) {
    toggle_inspector(s, inspector);
}
template <Inspector inspector>
bool uses_inspector(const AppState &s) {
    return s.inspector == inspector;
}
void next_layout(AppState &s) { set_layout(s, static_cast<Layout>((static_cast<std::size_t>(s.layout) + 1) % n_layouts)); }

void change_exposure(AppState &s, double ev) {
    s.look.exposure_ev = std::clamp(s.look.exposure_ev + ev, -10.0, 10.0);
}

void scale(AppState &s, double factor) { s.ui_scale = std::clamp(s.ui_scale * factor, smallest_ui_scale, largest_ui_scale); }

void hide_panels(AppState &s) {
    s.panels_hidden = !s.panels_hidden;
    s.before_by_mouse = false; // its button is gone
}

} // namespace

std::vector<Action> view_actions() {
    return {
        {"view.single", Menu::view, "One pane", "The active strategy alone.", {"Ctrl+1"}, use_layout<Layout::single>,
         nullptr, uses_layout<Layout::single>},
        {"view.two", Menu::view, "Two panes", "Two strategies side by side.", {"Ctrl+2"},
         use_layout<Layout::two>, nullptr, uses_layout<Layout::two>},
        {"view.four", Menu::view, "Four panes", "All four strategies.", {"Ctrl+4"},
         use_layout<Layout::four>, nullptr, uses_layout<Layout::four>},
        {"view.wipe", Menu::view, "Wipe",
         "Two strategies in one picture, one left of a divider and one right of it; drag the divider.", {"W"},
         use_layout<Layout::wipe>, nullptr, uses_layout<Layout::wipe>},
        {"view.flip", Menu::view, "Flip", "One of two strategies; done again, the other in the very same place.", {"Shift+W"},
         flip, nullptr, uses_layout<Layout::flip>},
        {"view.difference", Menu::view, "Difference",
         "The second of two strategies minus the first, at every point: brown where it is brighter, blue where it is darker.",
         {"Shift+D"}, use_layout<Layout::difference>, nullptr, uses_layout<Layout::difference>},
        {"view.unlink", Menu::view, "Unlink the views",
         "Each pane has a view of its own; done again, all have the active pane's.", {"Shift+L"}, toggle_cameras,
         [](const AppState &s) { return s.camera_is_set && n_places(s.layout) > 1; },
         [](const AppState &s) { return s.has_own_cameras(); }},
        {"view.unlink_tones", Menu::view, "Unlink exposure and range",
         "Each pane has its own exposure and range of colours; done again, all have the active pane's.", {"Shift+K"}, toggle_tones,
         [](const AppState &s) { return n_places(s.layout) > 1; }, [](const AppState &s) { return s.has_own_tones(); }},
        {"view.unlink_steps", Menu::view, "Unlink the steps",
         "Each pane stands at a step of its own, and stepping moves the active one; done again, all stand at the active pane's.",
         {"Shift+S"}, toggle_steps, [](const AppState &s) { return has_scene(s) && n_panes(s.layout) > 1; },
         [](const AppState &s) { return s.has_own_steps(); }},
        {"view.next_layout", Menu::view, "Next layout", "One pane, two panes, four panes, wipe, flip, difference, and so on.", {"Tab"},
         next_layout},
        {"view.lecture", Menu::view, "Preset: lecture", "One pane, large text, mesh and curves, no panels.", {"F5"}, preset_lecture},
        {"view.compare", Menu::view, "Preset: compare",
         "Uniform beside discontinuity meshing in the same basis, on one range that stays.", {"F6"}, preset_compare},
        {"view.inspect", Menu::view, "Preset: inspect", "One pane with mesh, curves and links, and the inspector.", {"F7"},
         preset_inspect},
        {"view.figure", Menu::view, "Preset: figure", "All four strategies on a light background, no panels.", {"F8"}, preset_figure},
        {"view.next_pane", Menu::view, "Next pane", "Makes the next pane the active one.", {"Shift+Tab"},
         [](AppState &s) { activate(s, (s.panes().active + 1) % n_panes(s.layout)); },
         [](const AppState &s) { return s.layout != Layout::single; }},
        {"view.reset", Menu::view, "Reset view", "Back to the eye that the scene began with.", {"R"}, reset_view,
         has_scene},
        {"view.fit", Menu::view, "Fit", "Moves the eye until the whole scene is in the frame.", {"F"}, fit_view,
         has_scene},
        {"view.keyhole", Menu::view, "Keyhole",
         "Shows what a point sees of each light; drag the point over a surface.", {"V"}, toggle_keyhole, has_scene,
         [](const AppState &s) { return s.keyhole.open; }},
        {"view.profile", Menu::view, "Profile along a line",
         "Plots the radiosity along a line, true and solved, and its slope; drag the line over a surface.", {"S"},
         toggle_profile, has_scene, [](const AppState &s) { return s.profile.open; }},
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
         [](AppState &s) { go_to_bookmark(s, s.bookmark + 1); },
         [](const AppState &s) { return s.bookmark + 1 < static_cast<int>(s.bookmarks.size()); }},
        {"view.previous_bookmark", Menu::view, "Previous bookmark", "Shows the view that was kept before.", {"PageUp"},
         [](AppState &s) { go_to_bookmark(s, s.bookmark - 1); }, [](const AppState &s) { return s.bookmark > 0; }},
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
        {"view.brighter", Menu::view, "Brighter", "Exposure up by half a stop.", {"E"},
         [](AppState &s) { change_exposure(s, 0.5); }},
        {"view.darker", Menu::view, "Darker", "Exposure down by half a stop.", {"Shift+E"},
         [](AppState &s) { change_exposure(s, -0.5); }},
        {"view.exposure_0", Menu::view, "Exposure 0 EV", "Exposure back to 0.", {"Ctrl+E"},
         [](AppState &s) { s.look.exposure_ev = 0; }},
        {"view.panels", Menu::view, "Hide panels", "The scene alone; the same key brings the panels back.", {"F11"},
         hide_panels, nullptr,
         [](const AppState &s) { return s.panels_hidden; }},
        {"view.theme", Menu::view, "Light background", "For projectors and print.", {"Shift+B"},
         [](AppState &s) { s.look.theme = s.chosen_theme = s.look.theme == Theme::dark ? Theme::light : Theme::dark; }, nullptr,
         [](const AppState &s) { return s.look.theme == Theme::light; }},
        {"view.before", Menu::view, "Before", "While it is held down, the panes show what was before the last step.",
         {"B"}, [](AppState &s) { s.before_by_key = true; }, can_go_back, [](const AppState &s) { return s.before_by_key; },
         [](AppState &s) { s.before_by_key = false; }},
        {"view.larger", Menu::view, "Larger text", "Scales the whole interface up.", {"Ctrl++", "Ctrl+="},
         [](AppState &s) { scale(s, 1.125); }},
        {"view.smaller", Menu::view, "Smaller text", "Scales the whole interface down.", {"Ctrl+-"},
         [](AppState &s) { scale(s, 1 / 1.125); }},
    };
}

} // namespace penumbra
