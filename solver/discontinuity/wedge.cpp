#include "discontinuity/wedge.h"

#include "geometry/predicates.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {
/// Heights nearer to the apex' than this have their sight line at infinity.
constexpr double level = 1e-13;
} // namespace

int Wedge::side(const Vec3 &q) const { return std::abs(height(q)) <= slack ? 0 : orientation(apex, a, b, q); }

double Wedge::parameter(const Vec3 &q) const {
    double drop = apex_height - receiver.height(q);
    if (std::abs(drop) < level)
        drop = std::copysign(level, drop);
    return along.dot(q - apex) * apex_height / drop;
}

Interval Wedge::below(const Vec3 &p, const Vec3 &q) const {
    const double hp = receiver.height(p), hq = receiver.height(q), top = apex_height - level;
    if (std::min(hp, hq) > top || std::max(hp, hq) < 0)
        return {0, 0};
    const auto at_height = [&](double h, const Vec3 &end, double h_end) -> Vec3 {
        if (h_end <= top && h_end >= 0)
            return end;
        return p + (h - hp) / (hq - hp) * (q - p);
    };
    const Vec3 from = at_height(std::clamp(hp, 0.0, top), p, hp), to = at_height(std::clamp(hq, 0.0, top), q, hq);
    return between(parameter(from), parameter(to));
}

Interval Wedge::above(const Vec3 &p, const Vec3 &q) const {
    const double hp = receiver.height(p), hq = receiver.height(q), bottom = apex_height + level;
    if (std::max(hp, hq) < bottom)
        return {0, 0};
    const auto raised = [&](const Vec3 &end, double h_end) -> Vec3 {
        return h_end >= bottom ? end : Vec3(p + (bottom - hp) / (hq - hp) * (q - p));
    };
    return between(parameter(raised(p, hp)), parameter(raised(q, hq)));
}

std::optional<Wedge> make_wedge(const Vec3 &apex, const Vec3 &a, const Vec3 &b, const PlaneFrame &receiver) {
    Wedge wedge{apex, a, b, Vec3::Zero(), receiver, receiver.height(apex), Vec3::Zero(), Vec3::Zero(), coincidence};
    const Vec3 across = (a - apex).cross(b - apex);
    if (across.norm() <= coincidence * (b - a).norm() || wedge.apex_height <= coincidence)
        return std::nullopt;
    wedge.normal = across.normalized();
    const Vec3 along = receiver.normal.cross(wedge.normal);
    if (along.norm() < coincidence)
        return std::nullopt;
    wedge.along = along.normalized();
    const Vec3 down = wedge.normal.cross(wedge.along); // in the plane, square to the line
    wedge.foot = apex - wedge.apex_height / down.dot(receiver.normal) * down;
    return wedge;
}

} // namespace penumbra
