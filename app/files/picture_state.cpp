#include "files/picture_state.h"

#include "timeline.h"

#include <algorithm>

namespace penumbra {

SavedPicture saved_picture(const PictureSpec &spec) {
    const bool lettered = std::ranges::any_of(spec.panes, [](const PicturePane &p) { return !p.tag.empty(); });
    return {spec.width, spec.height, lettered, !spec.price.empty(), spec.labels, spec.supersample};
}

SavedState picture_state(const PictureSpec &spec, const Scene &scene, const std::filesystem::path &folder, bool own_steps) {
    SavedState saved;
    saved.scene = scene.name;
    saved.file = place_of(scene, folder);
    saved.up = up_axis(scene);
    saved.options = spec.panes.front().snapshot->options;
    saved.strategies.clear();
    saved.converged = true;
    const auto add = [&](const Snapshot &snapshot) {
        saved.strategies.push_back(snapshot.options.strategy);
        saved.reconstructed.push_back(snapshot.reconstructed);
        saved.positions.push_back(position_of(snapshot.counters.iteration, snapshot.phase));
        saved.position = std::max(saved.position, saved.positions.back());
        saved.converged &= snapshot.counters.converged;
        if (snapshot.n_shown_events > 0)
            saved.split = std::max(saved.split.value_or(0), static_cast<int>(snapshot.n_shown_events));
        if (snapshot.n_shown_linkings > 0)
            saved.linking = std::max(saved.linking.value_or(0), static_cast<int>(snapshot.n_shown_linkings));
    };
    for (const PicturePane &pane : spec.panes) {
        if (pane.minus) {
            add(*pane.minus);
            saved.layout = Layout::difference;
            saved.active = 1;
        }
        add(*pane.snapshot);
        if (pane.camera)
            saved.cameras.push_back(*pane.camera);
        if (pane.tone)
            saved.tones.push_back(*pane.tone);
    }
    if (!own_steps)
        saved.positions.clear();
    else
        saved.position = saved.positions[static_cast<std::size_t>(saved.active)];
    if (spec.wipe) {
        saved.layout = Layout::wipe;
        saved.wipe = *spec.wipe;
    }
    saved.caption = spec.caption;
    saved.camera = spec.camera;
    saved.look = spec.look;
    if (spec.look.difference)
        saved.look.shading = Shading::polynomial; // of the other layouts
    saved.range_chosen = spec.look.range.has_value();
    saved.error_range_locked = spec.look.error_range.has_value();
    saved.legend = spec.legend;
    if (spec.keyhole)
        saved.keyhole = spec.keyhole->point;
    if (spec.profile)
        saved.profile = std::pair(spec.profile->from, spec.profile->to);
    saved.picture = saved_picture(spec);
    return saved;
}

} // namespace penumbra
