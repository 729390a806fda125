#include "keyhole_verbs.h"

#include "geometry/polygon.h"
#include "render/curve_crossing.h"
#include "render/event_words.h"
#include "render/surface_role.h"

#include <algorithm>
#include <utility>

namespace penumbra {

namespace {

constexpr double glow_seconds = 1.6;

std::size_t corners_of(const Keyhole &keyhole, int source) {
    for (const KeyholeEmitter &emitter : keyhole.emitters)
        if (emitter.whole.surface == source)
            return emitter.corners.size();
    return 0;
}

std::string corners_words(std::size_t n) { return n == 1 ? "1 corner" : std::to_string(n) + " corners"; }

void tell_crossing(AppState &state, const Snapshot &snapshot, const std::vector<CurveCrossing> &crossed,
                   const Keyhole &before, const Keyhole &after) {
    const int last = crossed.back().curve;
    const SnapshotCurve &curve = (*snapshot.curves)[static_cast<std::size_t>(last)];
    EventWords news = crossing_words(snapshot, curve, after.point);
    const std::size_t was = corners_of(before, curve.source), is = corners_of(after, curve.source);
    const std::string seen = "What is seen of " + surface_name(snapshot, curve.source);
    news.jump = was == is ? seen + " keeps " + corners_words(is) + "."
                          : seen + " has " + corners_words(is) + " now, " + std::to_string(was) + " before.";
    if (crossed.size() > 1)
        news.way += "; one of " + std::to_string(crossed.size()) + " curves that were crossed at once";
    state.keyhole.crossed = last;
    state.keyhole.crossed_at = Clock::now();
    state.message = {news.sentence + " (" + news.symbol + ")", false};
    state.keyhole.news = std::move(news);
}

double area_of(const SnapshotSurface &s) { return role(s) == SurfaceRole::reflector ? area(s.outline) : 0; }

} // namespace

void move_keyhole(AppState &state, int surface, const Vec3 &point) {
    const auto snapshot = state.active_solution();
    if (!snapshot || !state.scene || !state.scene->reflects(SurfaceId(surface)))
        return;
    KeyholeMode &mode = state.keyhole;
    if (mode.scene != state.scene) {
        mode.eye = std::make_shared<const KeyholeEye>(state.scene);
        mode.scene = state.scene;
        mode.seen.reset();
    }
    const auto before = mode.seen;
    mode.seen = std::make_shared<const Keyhole>(mode.eye->look(SurfaceId(surface), point));
    if (!before || before->surface != mode.seen->surface)
        return;
    if (const auto crossed = crossed_curves(*snapshot, surface, before->point, mode.seen->point); !crossed.empty())
        tell_crossing(state, *snapshot, crossed, *before, *mode.seen);
}

void toggle_keyhole(AppState &state) {
    state.keyhole.open = !state.keyhole.open;
    state.keyhole.crossed = -1;
    state.profile.open = state.profile.open && !state.keyhole.open; // both are dragged
    const auto snapshot = state.active_solution();
    if (!state.keyhole.open || !snapshot)
        return;
    state.message = {"Drag the point over a surface: the inset shows what it sees of each light.", false};
    if (state.under_cursor &&
        role(snapshot->surfaces[static_cast<std::size_t>(state.under_cursor->surface)]) == SurfaceRole::reflector) {
        move_keyhole(state, state.under_cursor->surface, state.under_cursor->point);
    } else if (!state.keyhole.seen || state.keyhole.scene != state.scene) {
        const auto largest = std::ranges::max_element(snapshot->surfaces, {}, area_of);
        move_keyhole(state, static_cast<int>(largest - snapshot->surfaces.begin()),
                     to_space(*largest, centroid(largest->outline)));
    }
}

double crossing_glows(const AppState &state, Clock::time_point now) {
    if (!state.keyhole.open || state.keyhole.crossed < 0)
        return -1;
    return glow_seconds - std::chrono::duration<double>(now - state.keyhole.crossed_at).count();
}

} // namespace penumbra
