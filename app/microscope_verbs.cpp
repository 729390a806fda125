#include "microscope_verbs.h"

#include "element_verbs.h"
#include "geometry/polygon.h"
#include "render/pick.h"
#include "render/surface_role.h"

#include <algorithm>

namespace penumbra {

namespace {

/// The splits above the patch at the point, the innermost first.
std::vector<int> splits_at(const Snapshot &snapshot, const SurfacePoint &at) {
    if (at.surface >= static_cast<int>(snapshot.surfaces.size()))
        return {};
    const int patch =
        patch_at(snapshot, at.surface, to_plane(snapshot.surfaces[static_cast<std::size_t>(at.surface)], at.point));
    return patch < 0 ? std::vector<int>() : splits_above(snapshot, patch);
}

/// The piece of the split that holds the point: the patch itself or what it is a part of.
int piece_at(const Snapshot &snapshot, const SurfacePoint &at, int split) {
    const Vec2 p = to_plane(snapshot.surfaces[static_cast<std::size_t>(at.surface)], at.point);
    for (SnapshotPlace place = snapshot.patches[static_cast<std::size_t>(patch_at(snapshot, at.surface, p))].place;
         place.split >= 0; place = snapshot.splits[static_cast<std::size_t>(place.split)].place)
        if (place.split == split)
            return place.piece;
    return 0;
}

/// Cuts before uniform splits, large before small.
void pick_largest(AppState &state, const Snapshot &snapshot) {
    const auto size = [](const SnapshotSplit &s) { return std::pair(s.kind == SplitKind::cut, area(s.corners)); };
    const auto largest = std::ranges::max_element(snapshot.splits, {}, size);
    if (largest == snapshot.splits.end())
        return;
    const auto &surface = snapshot.surfaces[static_cast<std::size_t>(largest->surface)];
    pick_split(state, {largest->surface, to_space(surface, centroid(largest->pieces.front().corners))});
    const std::vector<int> above = splits_at(snapshot, *state.microscope.at);
    const auto found = std::ranges::find(above, static_cast<int>(largest - snapshot.splits.begin()));
    state.microscope.outward = found == above.end() ? 0 : static_cast<int>(found - above.begin());
}

} // namespace

void toggle_inspector(AppState &state, Inspector inspector) {
    state.inspector = state.inspector == inspector ? Inspector::none : inspector;
    if (state.inspector == Inspector::element) {
        state.message = {"Click a patch: who lights it is shown, and a click on a row X-rays those links.", false};
        if (state.under_cursor && state.under_cursor->patch >= 0)
            pick_element(state, {state.under_cursor->surface, state.under_cursor->point});
    }
    if (state.inspector != Inspector::filters)
        return;
    state.message = {"Click a patch: the filters of the split that made it are shown.", false};
    if (state.under_cursor)
        pick_split(state, {state.under_cursor->surface, state.under_cursor->point});
}

void pick_split(AppState &state, const SurfacePoint &at) {
    state.microscope = {};
    state.microscope.at = at;
}

void step_outward(AppState &state, int by) {
    state.microscope.outward = std::clamp(state.microscope.outward + by, 0, std::max(0, state.microscope.n_splits - 1));
    state.microscope.shown.reset();
}

void update_microscope(AppState &state) {
    Microscope &m = state.microscope;
    const auto snapshot = state.active_solution();
    if (!snapshot) {
        m.shown.reset();
        return;
    }
    if (!m.at)
        pick_largest(state, *snapshot);
    const std::vector<int> above = m.at ? splits_at(*snapshot, *m.at) : std::vector<int>();
    m.n_splits = static_cast<int>(above.size());
    if (above.empty()) {
        m.shown.reset();
        return;
    }
    m.outward = std::min(m.outward, m.n_splits - 1);
    const int split = above[static_cast<std::size_t>(m.outward)];
    if (m.shown && m.version == snapshot->version && m.split == split)
        return;
    m.shown = std::make_shared<const SplitFilters>(split_filters(*snapshot, split));
    m.version = snapshot->version;
    m.split = split;
    m.piece = piece_at(*snapshot, *m.at, split);
}

} // namespace penumbra
