#include "profile_verbs.h"

#include "geometry/polygon.h"
#include "profile_data.h"
#include "render/surface_role.h"

#include <algorithm>

namespace penumbra {

namespace {

double lit_area(const SnapshotSurface &s) { return role(s) == SurfaceRole::reflector ? area(s.outline) : 0; }

/// Through the surface's middle, along the longer of its frame's directions, from border to border but for a tenth.
void cross_middle(AppState &state, const Snapshot &snapshot) {
    const auto largest = std::ranges::max_element(snapshot.surfaces, {}, lit_area);
    if (largest == snapshot.surfaces.end() || lit_area(*largest) <= 0)
        return;
    const Vec2 middle = centroid(largest->outline);
    Vec2 reach = Vec2::Zero();
    for (const Vec2 &p : largest->outline)
        reach = reach.cwiseMax((p - middle).cwiseAbs());
    const Vec2 way = 0.8 * (reach.x() >= reach.y() ? Vec2(reach.x(), 0) : Vec2(0, reach.y()));
    set_profile(state, static_cast<int>(largest - snapshot.surfaces.begin()), to_space(*largest, middle - way),
                to_space(*largest, middle + way));
}

} // namespace

void toggle_profile(AppState &state) {
    ProfileMode &mode = state.profile;
    mode.open = !mode.open;
    mode.dragging = ProfileGrip::none;
    mode.cursor.reset();
    if (!mode.open)
        return;
    state.keyhole.open = false;
    state.truth.halted = false;
    if (const auto snapshot = state.active_solution(); snapshot && !mode.line)
        cross_middle(state, *snapshot);
    state.message = {"Drag a line over a surface, or an end of it; the plot follows.", false};
}

void set_profile(AppState &state, int surface, const Vec3 &from, const Vec3 &to) {
    if ((from - to).norm() == 0)
        return;
    ProfileMode &mode = state.profile;
    mode.line = ProfileLine{surface, from, to};
    ++mode.asked;
    mode.exact.clear();
    mode.cursor.reset();
    mode.stale = true;
}

void update_profile(AppState &state) {
    ProfileMode &mode = state.profile;
    if (!mode.open || !mode.line)
        return;
    const std::vector<std::shared_ptr<const Snapshot>> solutions = state.shown_snapshots();
    std::vector<std::uint64_t> versions;
    for (const auto &snapshot : solutions)
        versions.push_back(snapshot->version);
    if (solutions.empty() || (!mode.stale && versions == mode.versions))
        return;
    mode.data = profile_frame(*solutions.front(), *mode.line);
    for (const auto &snapshot : solutions)
        mode.data.curves.push_back(profile_curve(*snapshot, *mode.line));
    mode.data.exact = mode.exact;
    mode.data.truth_error = state.truth.error;
    mode.versions = std::move(versions);
    mode.stale = false;
}

std::optional<ProfileQuestion> profile_question(const AppState &state) {
    const ProfileMode &mode = state.profile;
    const auto snapshot = state.active_solution();
    if (!mode.open || !mode.line || !mode.exact.empty() || !snapshot)
        return std::nullopt;
    return ProfileQuestion{mode.asked, *mode.line, snapshot->surfaces[static_cast<std::size_t>(mode.line->surface)],
                           break_places(profile_frame(*snapshot, *mode.line))};
}

} // namespace penumbra
