#include "window/picture_shot.h"

#include "files/picture_state.h"
#include "files/render_command.h"
#include "files/state_text.h"
#include "picture_verbs.h"
#include "truth_verbs.h"
#include "verbs.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

constexpr double slide_width = 1920; ///< pixels that a picture of the panes has at least

void set_size(PictureSpec &spec, const PictureSettings &settings, int width, int height) {
    const double scale = std::max(1.0, slide_width / width);
    const PixelSize chosen = pixels_of(settings.size);
    spec.width = chosen.width > 0 ? chosen.width : static_cast<int>(std::lround(scale * width));
    spec.height = chosen.width > 0 ? chosen.height : static_cast<int>(std::lround(scale * height));
}

/// So high that its panes have this aspect.
void fit_height(PictureSpec &spec, double aspect) {
    double low = 0.1 * spec.width, high = 4.0 * spec.width;
    for (int i = 0; i < 20; ++i) {
        spec.height = static_cast<int>(std::lround(0.5 * (low + high)));
        (pane_aspect(spec) > aspect ? low : high) = spec.height;
    }
}

/// All that panes of this aspect show from side to side is in the picture's, too.
void hold_widths(PictureSpec &spec, double aspect) {
    spec.camera = hold_width(spec.camera, aspect, pane_aspect(spec));
    for (PicturePane &pane : spec.panes)
        if (pane.camera)
            pane.camera = hold_width(*pane.camera, aspect, pane_aspect(spec));
}

/// All but the panes.
PictureSpec common_spec(const AppState &state, Layout layout, int width, int height) {
    PictureSpec spec;
    spec.columns = n_places(layout) == 1 ? 1 : 2;
    if (layout == Layout::wipe)
        spec.wipe = state.wipe;
    const PictureSettings &settings = state.pictures.settings;
    set_size(spec, settings, width, height);
    spec.supersample = settings.supersample;
    spec.labels = settings.labels;
    spec.camera = state.camera;
    spec.look = layout == state.layout ? state.shown_look() : state.look;
    if (layout != state.layout && state.layout == Layout::difference)
        spec.look.error_range.reset(); // the difference's
    spec.look.emphasise_fresh = false;
    spec.look.transparent = settings.transparent;
    if (state.keyhole.open)
        spec.keyhole = state.keyhole.seen;
    if (state.profile.open)
        spec.profile = state.profile.line;
    spec.look.spotlight.curve = state.pinned_curve.value_or(-1);
    spec.legend = !state.legend_hidden;
    spec.caption = state.caption;
    return spec;
}

std::string tag_of(Strategy strategy) { return std::string("(") + letter(strategy) + ")"; }

/// Without those that the pane has by itself.
Tone without_own_ranges(Tone tone, const PicturePane &pane, const Look &look) {
    const Tone own = with_ranges({}, pane, look);
    if (tone.range == own.range)
        tone.range.reset();
    if (look.shading != Shading::error || tone.error_range == own.error_range)
        tone.error_range.reset();
    return tone;
}

PictureShot finished(PictureSpec spec, const AppState &state, const std::filesystem::path &folder) {
    SavedState saved = saved_state(state, folder);
    saved.picture = saved_picture(spec);
    saved.camera = spec.camera;
    saved.cameras.clear();
    saved.tones.clear();
    for (const PicturePane &pane : spec.panes) {
        if (pane.camera)
            saved.cameras.push_back(*pane.camera);
        if (pane.tone)
            saved.tones.push_back(*pane.tone);
    }
    saved.look.emphasise_fresh = spec.look.emphasise_fresh;
    saved.look.transparent = spec.look.transparent;
    return {std::move(spec), std::move(saved)};
}

} // namespace

PictureShot shot_of_panes(const AppState &state, const std::filesystem::path &folder, int width, int height) {
    PictureSpec spec = common_spec(state, state.layout, width, height);
    const std::vector<Strategy> shown = state.shown();
    const auto minus = subtracted(state);
    for (const int pane : pictured_panes(state)) {
        if (minus && pane == 0)
            continue;
        spec.panes.push_back({state.shown_snapshot(pane), tag_of(shown[static_cast<std::size_t>(pane)]),
                              errors_of(state, pane), minus});
        if (state.has_own_cameras())
            spec.panes.back().camera = state.camera_of(pane);
        if (state.has_own_tones())
            spec.panes.back().tone = state.tone_of(pane);
    }
    if (state.pictures.settings.size != PictureSize::panes)
        hold_widths(spec, state.pane_aspect);
    return finished(std::move(spec), state, folder);
}

PictureShot shot_of(const AppState &state, const PendingPicture &picture, const std::filesystem::path &folder, int width,
                    int height) {
    PictureSpec spec = common_spec(state, picture.layout, width, height);
    std::vector<Strategy> shown;
    for (const int pane : pictured_panes(state))
        shown.push_back(state.panes().strategies[static_cast<std::size_t>(pane)]);
    const bool as_shown = picture.strategies == shown && n_places(picture.layout) == n_places(state.layout);
    const bool subtracts = picture.layout == Layout::difference;
    const auto minus = subtracts ? pictured(state, picture, 0) : nullptr;
    for (std::size_t pane = subtracts ? 1 : 0; pane < picture.strategies.size(); ++pane) {
        const auto snapshot = pictured(state, picture, pane);
        spec.panes.push_back({snapshot, tag_of(picture.strategies[pane]), pictured_errors(state, {snapshot, minus}), minus});
        if (state.has_own_cameras() && picture.layout == state.layout)
            spec.panes.back().camera = state.camera_of(static_cast<int>(pane));
        if (state.has_own_tones() && picture.layout == state.layout)
            spec.panes.back().tone = state.tone_of(static_cast<int>(pane));
    }
    if (!as_shown && state.pictures.settings.size == PictureSize::panes)
        fit_height(spec, state.pane_aspect);
    if (!as_shown || state.pictures.settings.size != PictureSize::panes)
        hold_widths(spec, state.pane_aspect);

    PictureShot shot = finished(std::move(spec), state, folder);
    shot.saved.strategies = picture.strategies;
    shot.saved.layout.reset();
    if (share_a_place(picture.layout))
        shot.saved.layout = picture.layout;
    shot.saved.reconstructed = picture.reconstructed;
    const auto active = std::ranges::find(picture.strategies, state.active_strategy());
    shot.saved.active = active == picture.strategies.end() ? 0 : static_cast<int>(active - picture.strategies.begin());
    shot.saved.options.strategy = picture.strategies[static_cast<std::size_t>(shot.saved.active)];
    shot.saved.position = picture.positions[static_cast<std::size_t>(shot.saved.active)];
    shot.saved.positions.clear();
    if (std::ranges::count(picture.positions, shot.saved.position) < std::ssize(picture.positions))
        shot.saved.positions = picture.positions;
    shot.saved.converged = std::ranges::all_of(
        shot.spec.panes, [](const PicturePane &pane) { return pane.snapshot->counters.converged; });
    return shot;
}

std::string command_of(const PictureShot &shot, const Scene &scene) {
    SavedState saved = shot.saved;
    if (!scene.file.empty())
        saved.file = std::filesystem::absolute(scene.file).lexically_normal().generic_string();
    std::vector<const Snapshot *> snapshots;
    for (const PicturePane &pane : shot.spec.panes)
        snapshots.push_back(pane.snapshot.get());
    if (saved.look.range == common_range(snapshots))
        saved.look.range.reset();
    for (std::size_t i = 0; i < saved.tones.size(); ++i)
        saved.tones[i] = without_own_ranges(saved.tones[i], shot.spec.panes[i], shot.spec.look);
    if (shot.spec.look.shading == Shading::error && saved.look.error_range == error_range(shot.spec.look.error, judged(shot.spec)))
        saved.look.error_range.reset();
    return render_command(saved);
}

} // namespace penumbra
