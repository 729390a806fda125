#include "agreement/random_pairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {

namespace {

class Draw {
public:
    explicit Draw(std::uint32_t seed) : engine_(seed) {}
    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    /// 10^-k, k in between.
    double small(double least, double most) { return std::pow(10, -in(least, most)); }
    bool heads() { return in(0, 1) < 0.5; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v(in(-1, 1), in(-1, 1), in(-1, 1));
            if (v.norm() > 0.1 && v.norm() < 1)
                return v.normalized();
        }
    }

private:
    std::mt19937 engine_;
};

/// In every second case an axis plane, whose frame has no rounding, in the others any plane.
PlaneFrame frame(Draw &draw) {
    PlaneFrame f{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    if (draw.heads()) {
        f.origin = Vec3(draw.in(-0.5, 0.5), draw.in(-0.5, 0.5), draw.in(-0.5, 0.5));
        f.normal = draw.direction();
        f.u = f.normal.unitOrthogonal();
        f.v = f.normal.cross(f.u);
    }
    return f;
}

/// A convex polygon about 0 with n corners on a circle that was squeezed; `slim`: width over length.
Polygon polygon(Draw &draw, int n, double slim = 1) {
    const double from = draw.in(0, 6.28), turn = draw.in(0, 6.28);
    Polygon out;
    for (int k = 0; k < n; ++k) {
        const double angle = from + 2 * std::numbers::pi * (k + draw.in(-0.3, 0.3)) / n;
        const Vec2 p(0.5 * std::cos(angle), 0.5 * slim * std::sin(angle));
        out.push_back(
            {std::cos(turn) * p.x() - std::sin(turn) * p.y(), std::sin(turn) * p.x() + std::cos(turn) * p.y()});
    }
    return out;
}

Polygon parallelogram(Draw &draw, double slim = 1) {
    const Polygon p = polygon(draw, 3, slim);
    return {p[0], p[1], p[1] + p[2] - p[0], p[2]};
}

/// An element of this outline, or of one like it that its family has.
struct Planted {
    ElementBasis element;
    bool any_part; ///< whether a part of it may be asked for
};

enum class Shape { any, sliver, triangle, part_of_parallelogram };

Planted planted(Draw &draw, Shape shape) {
    const double slim = shape == Shape::sliver ? draw.small(1, 5) : draw.in(0.3, 1);
    const int order = 2 + static_cast<int>(draw.in(0, 3));
    if (shape == Shape::triangle)
        return {ElementBasis(order, bilinear_quad(polygon(draw, 3, slim))), false};
    const double which = shape == Shape::part_of_parallelogram ? 0 : draw.in(0, 4);
    if (which < 1)
        return {ElementBasis(order, bilinear_quad(parallelogram(draw, slim))), true};
    if (which < 1.5)
        return {ElementBasis(order, bilinear_quad(polygon(draw, 4, slim))), false};
    if (which < 2)
        return {ElementBasis(order, bilinear_quad(polygon(draw, 3, slim))), false};
    return {ElementBasis(order, PlanarDomain(polygon(draw, 3 + static_cast<int>(draw.in(0, 4)), slim))), true};
}

/// What of the element lies in front of the plane through x with normal n; empty when a part was not to be.
Polygon seen(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const Planted &p) {
    ConvexPieces whole, front;
    whole.add(p.element.outline());
    clip(whole, {n.dot(source.u), n.dot(source.v), n.dot(source.origin - x)}, front);
    if (front.size() != 1 || (!p.any_part && !std::ranges::equal(front[0], p.element.outline())))
        return {};
    return {front[0].begin(), front[0].end()};
}

/// Tries until something is seen. `place` gives a point in front of the source for an element, and a normal.
template <class Place>
PointAndElement until_seen(std::uint32_t seed, Shape shape, const Place &place) {
    Draw draw(seed);
    for (;;) {
        const PlaneFrame source = frame(draw);
        const Planted p = planted(draw, shape);
        const auto [x, n] = place(draw, source, p.element.outline());
        if (source.height(x) <= 0)
            continue;
        const double least = 1e-3, most = shape == Shape::part_of_parallelogram ? 0.99 : 2;
        if (Polygon piece = seen(x, n, source, p);
            piece.size() > 2 && area(piece) > least * p.element.area() && area(piece) < most * p.element.area())
            return {x, n, source, p.element, std::move(piece)};
    }
}

using Place = std::pair<Vec3, Vec3>;

Vec3 raised(const PlaneFrame &source, const Vec2 &p, double height) {
    return source.to_space(p) + height * source.normal;
}

Vec2 mixed(Draw &draw, const Polygon &p) {
    Vec2 sum = Vec2::Zero();
    double all = 0;
    for (const Vec2 &c : p) {
        const double share = draw.in(0, 1);
        sum += share * c;
        all += share;
    }
    return sum / all;
}

Place far_off(Draw &draw, const PlaneFrame &source, const Polygon &) {
    const Vec3 away = draw.direction();
    return {source.origin + draw.in(1.5, 20) * away, draw.direction()};
}

Place near_by(Draw &draw, const PlaneFrame &source, const Polygon &p) {
    const Vec2 at = 1.5 * mixed(draw, p);
    return {raised(source, at, draw.small(0, 3)), draw.direction()};
}

/// On a plane that has an edge in common with the source, at an angle from 90 to 0.01 degrees.
Place at_an_edge(Draw &draw, const PlaneFrame &source, const Polygon &p) {
    const Vec2 edge = p[1] - p[0], along = edge.normalized(), inwards(-along.y(), along.x());
    const double angle = std::numbers::pi / 2 * draw.small(0, 4), away = draw.small(0, 12);
    const Vec2 foot = p[0] + draw.in(-0.2, 1.2) * edge + away * std::cos(angle) * inwards;
    const Vec3 n =
        std::sin(angle) * (inwards.x() * source.u + inwards.y() * source.v) - std::cos(angle) * source.normal;
    return {raised(source, foot, away * std::sin(angle)), n};
}

Place at_a_corner(Draw &draw, const PlaneFrame &source, const Polygon &p) {
    const Vec3 away = draw.direction();
    return {source.to_space(p[0]) + draw.small(0.5, 12) * away, draw.direction()};
}

Place beside_the_plane(Draw &draw, const PlaneFrame &source, const Polygon &) {
    const double angle = draw.in(0, 6.28);
    const Vec2 foot = draw.in(0.6, 2) * Vec2(std::cos(angle), std::sin(angle));
    return {raised(source, foot, draw.small(1, 12)), draw.heads() ? draw.direction() : Vec3(-source.normal)};
}

Place grazing_over(Draw &draw, const PlaneFrame &source, const Polygon &p) {
    return {raised(source, mixed(draw, p), draw.small(1, 12)), -source.normal};
}

Place over_sliver(Draw &draw, const PlaneFrame &source, const Polygon &p) {
    return {raised(source, 1.3 * mixed(draw, p), draw.small(0, 6)), draw.direction()};
}

} // namespace

const std::vector<PairSort> &pair_sorts() {
    static const std::vector<PairSort> sorts{
        {"far", [](std::uint32_t s) { return until_seen(s, Shape::any, far_off); }},
        {"near", [](std::uint32_t s) { return until_seen(s, Shape::any, near_by); }},
        {"edge", [](std::uint32_t s) { return until_seen(s, Shape::any, at_an_edge); }},
        {"corner", [](std::uint32_t s) { return until_seen(s, Shape::any, at_a_corner); }},
        {"beside", [](std::uint32_t s) { return until_seen(s, Shape::any, beside_the_plane); }},
        {"grazing", [](std::uint32_t s) { return until_seen(s, Shape::any, grazing_over); }},
        {"sliver", [](std::uint32_t s) { return until_seen(s, Shape::sliver, over_sliver); }},
        {"triangle", [](std::uint32_t s) { return until_seen(s, Shape::triangle, grazing_over); }},
        {"part", [](std::uint32_t s) { return until_seen(s, Shape::part_of_parallelogram, far_off); }},
    };
    return sorts;
}

} // namespace penumbra
