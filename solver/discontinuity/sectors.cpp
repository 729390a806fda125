#include "discontinuity/sectors.h"

#include "discontinuity/interval_set.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace penumbra {

namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double slight = 1e-7; ///< angles below this are rounding [radians]

double wrapped(double angle) {
    angle = std::fmod(angle, turn);
    return angle < 0 ? angle + turn : angle;
}

struct ViewFrame {
    Vec3 u, v;
    explicit ViewFrame(const Vec3 &line) : u(line.unitOrthogonal()), v(line.cross(u)) {}
    double angle(const Vec3 &d) const { return wrapped(std::atan2(d.dot(v), d.dot(u))); }
};

std::optional<Sector> sector(const FacetCone &cone, const Vec3 &point, const Vec3 &line, const ViewFrame &frame) {
    if (cone.whole)
        return Sector{0, turn};
    if (std::abs(line.dot(cone.facet->normal)) < coincidence)
        return std::nullopt;
    // A convex facet's centre of gravity lies within its cone, also when the cone is a half-plane.
    Vec3 inside = Vec3::Zero();
    for (const Vec3 &c : cone.facet->corners)
        inside += c - point;
    const double first = frame.angle(cone.first), second = frame.angle(cone.second);
    const double sweep = wrapped(second - first);
    return wrapped(frame.angle(inside) - first) <= sweep ? Sector{first, sweep} : Sector{second, turn - sweep};
}

/// The turn [0, 2 pi) less a sector.
void remove(IntervalSet &angles, const Sector &sector) {
    const double to = sector.from + sector.sweep;
    angles.subtract({sector.from, to});
    angles.subtract({sector.from - turn, to - turn});
}

} // namespace

FacetCone cone_at(const Facet &facet, const Vec3 &point) {
    const std::size_t n = facet.corners.size();
    for (std::size_t i = 0; i < n; ++i)
        if ((facet.corners[i] - point).norm() <= coincidence)
            return {&facet, false, facet.corners[(i + 1) % n] - point, facet.corners[(i + n - 1) % n] - point};
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = facet.corners[i], &b = facet.corners[(i + 1) % n];
        if ((b - a).cross(point - a).norm() <= coincidence * (b - a).norm())
            return {&facet, false, b - point, a - point};
    }
    return {&facet, true, Vec3::Zero(), Vec3::Zero()};
}

std::vector<Sector> free_sectors(std::span<const FacetCone> cones, const Vec3 &point, const Vec3 &line) {
    const ViewFrame frame(line);
    IntervalSet angles(Interval{0, turn});
    for (const FacetCone &cone : cones)
        if (const auto hidden = sector(cone, point, line, frame))
            remove(angles, *hidden);
    angles.drop_shorter(slight);
    std::vector<Sector> free;
    for (const Interval &i : angles.intervals())
        free.push_back({i.low, i.length()});
    // The first and the last may be one that passes through angle zero.
    if (free.size() > 1 && free.front().from == 0 && free.back().from + free.back().sweep == turn) {
        free.front() = {free.back().from, free.back().sweep + free.front().sweep};
        free.pop_back();
    }
    return free;
}

bool shows_corner(std::span<const Sector> free) {
    if (free.empty())
        return false;
    return free.size() > 1 || (free[0].sweep < turn && std::abs(free[0].sweep - turn / 2) > slight);
}

bool shows_any(std::span<const FacetCone> cones, const Vec3 &point, const Vec3 &line, std::span<const Sector> free) {
    const ViewFrame frame(line);
    for (const FacetCone &cone : cones) {
        const auto own = sector(cone, point, line, frame);
        if (!own)
            continue;
        IntervalSet seen;
        for (const Sector &s : free)
            for (const double shift : {-turn, 0.0, turn})
                seen.unite({s.from + shift, s.from + s.sweep + shift});
        seen.clip(Interval{own->from, own->from + own->sweep});
        seen.drop_shorter(slight);
        if (!seen.empty())
            return true;
    }
    return false;
}

} // namespace penumbra
