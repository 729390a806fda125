#include "menu_actions.h"

#include "render/error_scale.h"
#include "truth_verbs.h"
#include "verbs.h"

#include <iterator>

namespace penumbra {

namespace {

template <Shading shading>
void use_shading(AppState &s) {
    s.look.shading = shading;
    s.look.change.reset();
}
template <Shading shading>
bool uses_shading(const AppState &s) {
    return s.look.shading == shading;
}

template <ErrorKind kind>
void use_error(AppState &s) {
    show_errors(s, kind);
}
template <ErrorKind kind>
bool uses_error(const AppState &s) {
    return s.look.shading == Shading::error && s.look.error == kind;
}
bool shows_errors(const AppState &s) { return s.look.shading == Shading::error; }
/// A difference has its own shading.
bool has_shading(const AppState &s) { return has_scene(s) && s.layout != Layout::difference; }

void flip_errors(AppState &s) {
    if (shows_errors(s))
        use_shading<Shading::polynomial>(s);
    else
        show_errors(s, s.look.error);
}
void next_error(AppState &s) {
    constexpr int n = static_cast<int>(std::size(all_error_kinds));
    show_errors(s, shows_errors(s) ? static_cast<ErrorKind>((static_cast<int>(s.look.error) + 1) % n) : s.look.error);
}

void next_shading(AppState &s) {
    constexpr Shading next[] = {Shading::flat, Shading::linear, Shading::polynomial, Shading::polynomial};
    s.look.shading = next[static_cast<std::size_t>(s.look.shading)];
    s.look.change.reset();
}

bool ranges_errors(const AppState &s) { return s.shown_look().shading == Shading::error; }
bool range_is_locked(const AppState &s) { return ranges_errors(s) ? s.truth.range_locked : s.chosen_range.has_value(); }
/// Of the errors, where these are shown, else of the radiosity.
void flip_range_lock(AppState &s) {
    if (ranges_errors(s)) {
        toggle_range_lock(s);
        return;
    }
    s.chosen_range = s.chosen_range ? std::nullopt : s.look.range;
    s.message = {s.chosen_range ? "The range of colours stays as it is." : "The range of colours follows what is shown.", false};
}

} // namespace

std::vector<Action> layer_actions() {
    return {
        {"layers.mesh", Menu::layers, "Mesh", "Sides of the patches.", {"M"},
         [](AppState &s) { s.look.layers.mesh = !s.look.layers.mesh; }, nullptr,
         [](const AppState &s) { return s.look.layers.mesh; }},
        {"layers.curves", Menu::layers, "Discontinuity curves", "Where the light or one of its derivatives jumps.",
         {"D"}, [](AppState &s) { s.look.layers.curves = !s.look.layers.curves; }, nullptr,
         [](const AppState &s) { return s.look.layers.curves; }},
        {"layers.links", Menu::layers, "Links", "From the centre of each receiving element to its sources.", {"L"},
         [](AppState &s) { s.look.layers.links = !s.look.layers.links; }, nullptr,
         [](const AppState &s) { return s.look.layers.links; }},
        {"layers.fresh", Menu::layers, "Highlight new patches", "Outlines for a moment what the last refinement made.",
         {"N"}, [](AppState &s) { s.look.emphasise_fresh = !s.look.emphasise_fresh; }, nullptr,
         [](const AppState &s) { return s.look.emphasise_fresh; }},
        {"layers.next_shading", Menu::layers, "Next shading", "Polynomial, flat, linear, and so on.", {"P"}, next_shading,
         has_shading},
        {"layers.polynomial", Menu::layers, "Polynomial", "The solution itself, evaluated at every pixel.", {},
         use_shading<Shading::polynomial>, has_shading, uses_shading<Shading::polynomial>},
        {"layers.flat", Menu::layers, "Flat", "The mean of each patch.", {}, use_shading<Shading::flat>, has_shading,
         uses_shading<Shading::flat>},
        {"layers.linear", Menu::layers, "Linear", "Gouraud's interpolation of averaged corner values.", {},
         use_shading<Shading::linear>, has_shading, uses_shading<Shading::linear>},
        {"layers.error", Menu::layers, "Error", "How wrong the solution is, in place of the light.", {"X"}, flip_errors,
         has_shading, shows_errors},
        {"error.next", Menu::layers, "Next kind of error", "Signed, relative, of the patch, against the estimate.",
         {"Shift+X"}, next_error, has_shading},
        {"error.signed", Menu::layers, "Signed error", error_sentence(ErrorKind::signed_error), {},
         use_error<ErrorKind::signed_error>, has_shading, uses_error<ErrorKind::signed_error>},
        {"error.relative", Menu::layers, "Relative error", error_sentence(ErrorKind::relative), {},
         use_error<ErrorKind::relative>, has_shading, uses_error<ErrorKind::relative>},
        {"error.patch", Menu::layers, "Error of each patch", error_sentence(ErrorKind::patch), {},
         use_error<ErrorKind::patch>, has_shading, uses_error<ErrorKind::patch>},
        {"error.estimate", Menu::layers, "Error against the estimate", error_sentence(ErrorKind::estimate), {},
         use_error<ErrorKind::estimate>, has_shading, uses_error<ErrorKind::estimate>},
        {"layers.lock_range", Menu::layers, "Lock the range",
         "Keeps the scale of colours, or of errors, as it is through steps and strategies, so that they can be compared.", {"K"},
         flip_range_lock, has_scene, range_is_locked},
        {"layers.false_colour", Menu::layers, "False colour", "Radiosity on the cividis scale, with its legend.", {"C"},
         [](AppState &s) { s.look.false_colour = !s.look.false_colour; }, nullptr,
         [](const AppState &s) { return s.look.false_colour; }},
        {"layers.legend", Menu::layers, "Legend", "Scales and line kinds in the picture.", {"G"},
         [](AppState &s) { s.legend_hidden = !s.legend_hidden; }, nullptr,
         [](const AppState &s) { return !s.legend_hidden; }},
    };
}

} // namespace penumbra
