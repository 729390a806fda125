#include "window/take_picture.h"

#include "capture.h"
#include "files/picture_state.h"
#include "files/pictures_folder.h"
#include "files/state_text.h"
#include "files/write_state.h"
#include "render/picture.h"
#include "truth_verbs.h"
#include "verbs.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <utility>

namespace penumbra {

namespace {

constexpr double slide_width = 1920; ///< pixels that a picture of the panes has at least

PictureSpec panes_spec(const AppState &state, int width, int height) {
    PictureSpec spec;
    const double scale = std::max(1.0, slide_width / width);
    spec.width = static_cast<int>(std::lround(scale * width));
    spec.height = static_cast<int>(std::lround(scale * height));
    spec.columns = state.layout == Layout::single ? 1 : 2;
    const std::vector<Strategy> shown = state.shown();
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        spec.panes.push_back({state.shown_snapshot(pane),
                              std::string("(") + letter(shown[static_cast<std::size_t>(pane)]) + ")",
                              errors_of(state, pane)});
    spec.camera = state.camera;
    spec.look = state.look;
    spec.look.emphasise_fresh = false;
    if (state.keyhole.open)
        spec.keyhole = state.keyhole.seen;
    if (state.profile.open)
        spec.profile = state.profile.line;
    spec.look.spotlight.curve = state.pinned_curve.value_or(-1);
    spec.legend = !state.legend_hidden;
    spec.caption = state.caption;
    return spec;
}

bool all_known(const AppState &state) {
    return std::ranges::all_of(state.shown(), [&](Strategy s) { return state.snapshot(s) != nullptr; });
}

} // namespace

void take_picture(AppState &state, PictureRequest request, int width, int height) {
    if (request == PictureRequest::panes && !all_known(state)) {
        state.message = {"There is nothing to take a picture of yet.", false};
        return;
    }
    try {
        const std::string given = std::exchange(state.picture_file, {});
        const std::filesystem::path file = given.empty() ? numbered_name(pictures_folder(), "penumbra") : std::filesystem::path(given);
        SavedState saved = saved_state(state, file.parent_path());
        Image image;
        if (request == PictureRequest::panes) {
            const PictureSpec spec = panes_spec(state, width, height);
            image = draw_picture(spec);
            saved.picture = saved_picture(spec);
            saved.look.emphasise_fresh = spec.look.emphasise_fresh;
        } else {
            image = read_pixels(0, 0, width, height);
        }
        write_png(file, image, state_text(saved));
        state.last_picture = file.string();
        state.message = {"Saved " + file.string(), false};
    } catch (const std::exception &e) {
        state.message = {e.what(), true};
    }
}

} // namespace penumbra
