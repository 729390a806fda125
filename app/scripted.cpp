#include "scripted.h"

#include "history.h"

#include <tuple>

namespace penumbra {

namespace {

auto parts(auto &s) {
    auto &p = s.set;
    return std::tie(p.moves, p.options, p.layout, p.pane_sets, p.wipe, p.look, p.camera, p.pane_cameras, p.pane_tones,
                    p.steps_unlinked, p.keyhole, p.profile, p.pinned_curve,
                    p.legend_hidden, s.place, s.speed, s.caption, s.inspector, s.element, s.split, s.outward, s.piece,
                    s.source, s.xray, s.object, s.cost, s.pivot, s.pictures, s.picture_settings, s.help, s.panels_hidden,
                    s.animates_splits, s.bookmarks, s.bookmark);
}

} // namespace

Scripted scripted(const AppState &state) {
    Scripted s;
    s.set = parameters(state);
    if (!state.camera_is_set)
        s.set.camera.reset(); // the first view will be taken
    s.place = {state.position, state.split, state.linking};
    s.playing = state.playing;
    s.speed = state.phases_per_second;
    s.caption = state.caption;
    s.inspector = state.inspector;
    s.element = state.element.at;
    s.split = state.microscope.at;
    s.outward = state.microscope.outward;
    s.piece = state.microscope.piece;
    s.source = state.element.source;
    s.xray = state.element.line;
    s.object = state.objects.chosen;
    s.cost = state.cost_measure;
    s.pivot = state.pivot;
    s.pictures = state.pictures.settings;
    s.picture_settings = state.pictures.settings_open;
    s.help = state.help_open;
    s.panels_hidden = state.panels_hidden;
    s.animates_splits = state.animates_splits;
    for (const SavedState &bookmark : state.bookmarks)
        s.bookmarks.push_back(bookmark.caption);
    s.bookmark = state.bookmark;
    return s;
}

void follow(Scripted &known, const Scripted &before, const Scripted &after) {
    const auto each = [&]<std::size_t... i>(std::index_sequence<i...>) {
        const auto one = [](auto &k, const auto &b, const auto &a) {
            if (k == b)
                k = a;
        };
        auto k = parts(known);
        const auto b = parts(before), a = parts(after);
        (one(std::get<i>(k), std::get<i>(b), std::get<i>(a)), ...);
    };
    each(std::make_index_sequence<std::tuple_size_v<decltype(parts(known))>>());
}

} // namespace penumbra
