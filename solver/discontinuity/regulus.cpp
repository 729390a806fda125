#include "discontinuity/regulus.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

/// ((p + s d) . a) (c + s e), and the like: products of two linear polynomials.
Quadratic product(double a0, double a1, double b0, double b1) { return {{a0 * b0, a0 * b1 + a1 * b0, a1 * b1}}; }
Quadratic minus(const Quadratic &a, const Quadratic &b) {
    return {{a.c[0] - b.c[0], a.c[1] - b.c[1], a.c[2] - b.c[2]}};
}

/// Where u in [low, high]; u = n / d, a Moebius function of s.
void clip_to_part(IntervalSet &set, const Quadratic &n, const Quadratic &d, const Interval &part) {
    std::vector<double> ends;
    const Interval all{set.intervals().front().low, set.intervals().back().high};
    for (const double u : {part.low, part.high})
        Quadratic{{n.c[0] - u * d.c[0], n.c[1] - u * d.c[1], 0}}.add_roots(all, ends);
    Quadratic{{d.c[0], d.c[1], 0}}.add_roots(all, ends);
    for (const double s : ends)
        set.split(s);
    IntervalSet kept;
    for (const Interval &i : set.intervals()) {
        const double s = i.middle(), u = n(s) / d(s);
        if (u > part.low && u < part.high)
            kept.unite(i);
    }
    set = std::move(kept);
}

} // namespace

void Quadratic::add_roots(const Interval &within, std::vector<double> &roots) const {
    const double scale = std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2])});
    if (scale == 0)
        return;
    const auto add = [&](double s) {
        if (s > within.low && s < within.high)
            roots.push_back(s);
    };
    const double half = c[1] / 2, d = half * half - c[0] * c[2];
    if (d < 0)
        return;
    const double q = -(half + std::copysign(std::sqrt(d), half));
    if (std::abs(c[2]) > 0)
        add(q / c[2]);
    if (q != 0)
        add(c[0] / q);
}

std::optional<Regulus> Regulus::make(const std::array<const SightEdge *, 3> &edges, const PlaneFrame &receiver) {
    for (std::size_t k = 0; k < 3; ++k)
        if (in_one_plane(*edges[k], *edges[(k + 1) % 3]))
            return std::nullopt;
    Regulus r;
    r.edges_ = edges;
    r.receiver_ = receiver;
    // All relative to the first edge's a. The plane through P(s) and the second edge has the normal n0 + s n1.
    const Vec3 d1 = edges[0]->b - edges[0]->a;
    const Vec3 a2 = edges[1]->a - edges[0]->a, d2 = edges[1]->b - edges[1]->a;
    const Vec3 a3 = edges[2]->a - edges[0]->a, d3 = edges[2]->b - edges[2]->a;
    const auto meet = [&](const Vec3 &a, const Vec3 &d, const Vec3 &b, const Vec3 &e, Quadratic(&u)[2]) {
        // Where the line b + u e crosses the plane through P(s) and the line a + t d.
        const Vec3 n0 = a.cross(d), n1 = -d1.cross(d);
        u[0] = {{-n0.dot(b - a), -n1.dot(b - a), 0}};
        u[1] = {{n0.dot(e), n1.dot(e), 0}};
    };
    meet(a2, d2, a3, d3, r.u3_);
    meet(a3, d3, a2, d2, r.u2_);
    // The point on the third edge, homogeneous: N(s) over D(s).
    const double D[2] = {r.u3_[1].c[0], r.u3_[1].c[1]};
    const Vec3 N[2] = {a3 * D[0] + d3 * r.u3_[0].c[0], a3 * D[1] + d3 * r.u3_[0].c[1]};
    r.v_[0] = N[0];
    r.v_[1] = N[1] - D[0] * d1;
    r.v_[2] = -D[1] * d1;
    r.m_[0] = Vec3::Zero();
    r.m_[1] = d1.cross(N[0]);
    r.m_[2] = d1.cross(N[1]);
    // The foot: P h(N) - N h(P), over h(N) - D h(P), with heights over the receiver.
    const Vec3 o = receiver.origin - edges[0]->a;
    const auto linear = [&](const Vec3 &axis, double(&p)[2], double(&n)[2]) {
        p[0] = -axis.dot(o);
        p[1] = axis.dot(d1);
        for (int k = 0; k < 2; ++k)
            n[k] = axis.dot(N[k] - D[k] * o);
    };
    double pu[2], nu[2], pv[2], nv[2], ph[2], nh[2];
    linear(receiver.u, pu, nu);
    linear(receiver.v, pv, nv);
    linear(receiver.normal, ph, nh);
    r.x_ = minus(product(pu[0], pu[1], nh[0], nh[1]), product(nu[0], nu[1], ph[0], ph[1]));
    r.y_ = minus(product(pv[0], pv[1], nh[0], nh[1]), product(nv[0], nv[1], ph[0], ph[1]));
    r.w_ = minus({{nh[0], nh[1], 0}}, product(D[0], D[1], ph[0], ph[1]));
    return r;
}

IntervalSet Regulus::domain() const {
    IntervalSet set(edges_[0]->part);
    if (!set.empty())
        clip_to_part(set, u2_[0], u2_[1], edges_[1]->part);
    if (!set.empty())
        clip_to_part(set, u3_[0], u3_[1], edges_[2]->part);
    return set;
}

Quadratic Regulus::side(const Vec3 &p, const Vec3 &q) const {
    const Vec3 &origin = edges_[0]->a;
    const Vec3 direction = q - p, moment = (p - origin).cross(q - origin);
    Quadratic s;
    for (int k = 0; k < 3; ++k)
        s.c[k] = v_[k].dot(moment) + direction.dot(m_[k]);
    return s;
}

Quadratic Regulus::foot_height(const PlaneFrame &plane) const {
    const double u = plane.normal.dot(receiver_.u), v = plane.normal.dot(receiver_.v), h = plane.height(receiver_.origin);
    Quadratic height;
    for (int k = 0; k < 3; ++k)
        height.c[k] = u * x_.c[k] + v * y_.c[k] + h * w_.c[k];
    return height;
}

Vec2 Regulus::foot(double s) const { return Vec2(x_(s), y_(s)) / w_(s); }

SightLine Regulus::line(double s) const {
    const Vec3 v = (v_[0] + s * (v_[1] + s * v_[2])).normalized();
    return {receiver_.to_space(foot(s)), v.dot(receiver_.normal) > 0 ? v : Vec3(-v)};
}

void Regulus::set_arc(Curve &curve, const Interval &arc) const {
    const auto point = [&](double s, double t) { return Vec3(x_.polar(s, t), y_.polar(s, t), w_.polar(s, t)); };
    const Vec3 a = point(arc.low, arc.low), b = point(arc.low, arc.high), c = point(arc.high, arc.high);
    curve.from = a.head<2>() / a.z();
    curve.to = c.head<2>() / c.z();
    curve.control = b / std::copysign(std::sqrt(a.z() * c.z()), a.z());
}

} // namespace penumbra
