#include "transport/moment_rules.h"

#include "basis/gauss.h"

#include <cmath>
#include <limits>

namespace penumbra {

namespace {

/// Gauss points on [from, to] in panels no longer than 3: in a variable graded by sinh the kernel's poles stand pi/2
/// off the real axis, so that each panel converges as 2.5^(-2n).
class Panels {
public:
    Panels(double from, double to, int n)
        : rule_(gauss_rule(n)), count_(std::max(1, static_cast<int>(std::ceil((to - from) / 3)))), from_(from),
          width_((to - from) / count_) {}

    template <class Visit>
    void for_each(const Visit &visit) const {
        for (int k = 0; k < count_; ++k)
            for (std::size_t i = 0; i < rule_.points.size(); ++i)
                visit(from_ + width_ * (k + rule_.points[i]), width_ * rule_.weights[i]);
    }

private:
    const GaussRule &rule_;
    int count_;
    double from_, width_;
};

/// A rule for the integral of f(r) r dr over [0, 1], graded as r = sinh(s z) / sinh(z).
struct RadialRule {
    std::vector<double> radii, weights;

    void set(double z, int n) {
        radii.clear();
        weights.clear();
        const double end = std::sinh(z);
        Panels(0, z, n).for_each([&](double s, double weight) {
            const double r = std::sinh(s) / end;
            radii.push_back(r);
            weights.push_back(weight * r * std::cosh(s) / end);
        });
    }
};

/// From `end` towards `to`, graded away from `end` at the scale `near`, or evenly where that is no small part of the
/// way.
template <class Visit>
void graded(double end, double to, double near, int n, const Visit &visit) {
    const double way = std::abs(to - end), sign = to < end ? -1 : 1;
    if (near >= 2 * way) {
        const GaussRule &rule = gauss_rule(n);
        for (std::size_t i = 0; i < rule.points.size(); ++i)
            visit(end + (to - end) * rule.points[i], way * rule.weights[i]);
        return;
    }
    Panels(0, std::asinh(way / near), n).for_each([&](double w, double weight) {
        visit(end + sign * near * std::sinh(w), weight * near * std::cosh(w));
    });
}

/// An interval, graded from both its ends, or as one panel where neither asks for it.
template <class Visit>
void graded_from_both(double from, double to, double near_from, double near_to, int n, const Visit &visit) {
    if (std::min(near_from, near_to) >= to - from)
        return graded(from, to, 2 * (to - from), n, visit);
    const double middle = (from + to) / 2;
    graded(from, middle, near_from, n, visit);
    graded(to, middle, near_to, n, visit);
}

/// Rays apex + r D(u), D(u) = a + u (b - a), that sweep a triangle, and what of them lies in a convex piece.
class Fan {
public:
    Fan(const Eye &eye, std::span<const Vec2> piece, const BilinearQuad &triangle) : eye_(eye) {
        const Polygon corners = triangle.outline();
        std::size_t k = 0;
        while (triangle.corners[k] != triangle.corners[(k + 1) % 4])
            ++k;
        apex_ = triangle.corners[k];
        a_ = triangle.corners[(k + 2) % 4] - apex_;
        b_ = triangle.corners[(k + 3) % 4] - apex_;
        turn_ = cross(a_, b_);
        foot_ = eye.foot - apex_;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const Vec2 from = piece[i] - apex_, along = piece[(i + 1) % piece.size()] - piece[i];
            edges_.push_back({from, along, cross(along, from)});
            const double r = (cross(a_, from) + cross(from, b_)) / turn_;
            nearest_r_ = std::min(nearest_r_, r);
            farthest_r_ = std::max(farthest_r_, r);
        }
    }

    double turn() const { return turn_; }
    Vec2 ray(double u) const { return a_ + u * (b_ - a_); }
    Vec2 at(const Vec2 &ray, double r) const { return apex_ + r * ray; }

    /// Where the ways of the rays through the piece change, or come near to x: ascending.
    std::vector<double> breaks() const {
        std::vector<double> out;
        for (const Edge &e : edges_)
            add_direction(e.from, out);
        if (out.empty())
            return out;
        std::ranges::sort(out);
        const double first = out.front(), last = out.back();
        std::vector<double> near;
        add_direction(foot_, near);
        for (const Edge &e : edges_)
            if (const double t = (foot_ - e.from).dot(e.along) / e.along.squaredNorm(); t > 0 && t < 1)
                add_direction(e.from + t * e.along, near);
        for (const double u : near)
            if (u > first && u < last)
                out.push_back(u);
        std::ranges::sort(out);
        out.erase(std::ranges::unique(out, [](double s, double t) { return t - s < 1e-15; }).begin(), out.end());
        return out;
    }

    /// The borders that rays between two neighbouring breaks enter and leave by.
    struct Way {
        int in = -1, out = -1;
    };
    Way way(double u) const {
        const Vec2 d = ray(u);
        Way way;
        double low = 0, high = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const double across = cross(edges_[i].along, d), r = edges_[i].offset / across;
            if (across > 0 && r > low) {
                low = r;
                way.in = static_cast<int>(i);
            } else if (across < 0 && r < high) {
                high = r;
                way.out = static_cast<int>(i);
            }
        }
        return low < high ? way : Way{};
    }
    double reach(int edge, const Vec2 &d) const {
        const Edge &e = edges_[static_cast<std::size_t>(edge)];
        // Where an edge runs along the rays its crossing has no digits; the piece's corners bound it.
        const double r = e.offset / cross(e.along, d);
        return r >= nearest_r_ ? std::min(r, farthest_r_) : std::max(0.0, nearest_r_);
    }
    double low(const Way &way, const Vec2 &d) const { return way.in < 0 ? 0 : reach(way.in, d); }
    double high(const Way &way, const Vec2 &d) const { return std::max(low(way, d), reach(way.out, d)); }

    /// r of the point nearest to x between the two.
    double nearest(const Vec2 &d, double low, double high) const {
        return std::clamp(d.dot(foot_) / d.squaredNorm(), low, high);
    }
    double distance(const Vec2 &d, double r) const { return std::hypot(eye_.height, (r * d - foot_).norm()); }
    /// By how much u has to change for the nearest point to go as far as it is from x.
    double grading(const Way &way, double u) const {
        const Vec2 d = ray(u);
        const double r = nearest(d, low(way, d), high(way, d));
        return distance(d, r) * d.norm() / std::max(r * turn_, 1e-300);
    }

private:
    struct Edge {
        Vec2 from, along;
        double offset;
    };
    void add_direction(const Vec2 &p, std::vector<double> &out) const {
        const double left = cross(a_, p), right = cross(p, b_);
        if (left + right > 1e-12 * turn_) // a point at the apex has no direction
            out.push_back(std::clamp(left / (left + right), 0.0, 1.0));
    }

    const Eye &eye_;
    Vec2 apex_, a_, b_, foot_;
    double turn_;
    double nearest_r_ = 1, farthest_r_ = 0; ///< of the piece's corners
    std::vector<Edge> edges_;
};

} // namespace

void add_far(const Eye &eye, std::span<const Vec2> piece, int n, WeightedPoints &out) {
    const GaussRule &rule = gauss_rule(n);
    for (std::size_t k = 1; k + 1 < piece.size(); k += 2) {
        const BilinearQuad quad{{piece[0], piece[k], piece[k + 1], piece[std::min(k + 2, piece.size() - 1)]}};
        for (std::size_t i = 0; i < rule.points.size(); ++i)
            for (std::size_t j = 0; j < rule.points.size(); ++j) {
                const double u = rule.points[i], v = rule.points[j];
                const Vec2 p = quad.at(u, v);
                const Vec3 d = eye.base + p.x() * eye.source.u + p.y() * eye.source.v;
                out.add(p, rule.weights[i] * rule.weights[j] * quad.jacobian(u, v) *
                               eye.kernel(eye.n.dot(d), d.squaredNorm()));
            }
    }
}

void add_near(const Eye &eye, std::span<const Vec2> piece, const Vec2 &nearest, double distance, int n,
              WeightedPoints &out) {
    // One radial grading for all directions, that of the longest: shorter reaches only move the poles away.
    double longest = 0;
    for (const Vec2 &corner : piece)
        longest = std::max(longest, (corner - nearest).norm());
    thread_local RadialRule radial;
    radial.set(std::asinh(longest / distance), n);
    const double facing = eye.facing(nearest);
    const Vec2 n_plane = eye.n_plane();
    for (std::size_t k = 0; k < piece.size(); ++k) {
        const Vec2 a = piece[k] - nearest, b = piece[k + 1 < piece.size() ? k + 1 : 0] - nearest;
        const double length = (b - a).norm();
        if (length == 0)
            continue;
        const Vec2 along = (b - a) / length;
        const double off = std::abs(cross(along, a)); // of y* from the edge's line
        if (off <= 1e-15 * length)
            continue;
        const double from = a.dot(along), to = b.dot(along); // along the edge, 0 at the foot of y*
        const Vec2 foot = a - from * along;
        const double scale = std::max(off, distance);
        Panels(std::asinh(from / scale), std::asinh(to / scale), n).for_each([&](double w, double w_weight) {
            const Vec2 reach = foot + scale * std::sinh(w) * along;
            const double area = w_weight * scale * std::cosh(w) * off; // twice that of the triangle
            // |y - x|^2 and n . (y - x) along the ray to the edge.
            const double r2_1 = 2 * reach.dot(nearest - eye.foot), r2_2 = reach.squaredNorm();
            const double turn = reach.dot(n_plane);
            for (std::size_t i = 0; i < radial.radii.size(); ++i) {
                const double s = radial.radii[i];
                const double r2 = distance * distance + s * (r2_1 + s * r2_2);
                out.add(nearest + s * reach, area * radial.weights[i] * eye.kernel(facing + s * turn, r2));
            }
        });
    }
}

void add_fan(const Eye &eye, std::span<const Vec2> piece, const BilinearQuad &triangle, int n, WeightedPoints &out) {
    const Fan fan(eye, piece, triangle);
    const std::vector<double> breaks = fan.breaks();
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const double from = breaks[k], to = breaks[k + 1];
        const Fan::Way way = fan.way((from + to) / 2);
        if (way.out < 0)
            continue;
        graded_from_both(from, to, fan.grading(way, from), fan.grading(way, to), n, [&](double u, double u_weight) {
            const Vec2 d = fan.ray(u);
            const double low = fan.low(way, d), high = fan.high(way, d), nearest = fan.nearest(d, low, high);
            const double near = fan.distance(d, nearest) / d.norm();
            const auto add = [&](double r, double r_weight) {
                const Vec2 p = fan.at(d, r);
                out.add(p, u_weight * r_weight * r * fan.turn() *
                               eye.kernel(eye.facing(p), eye.height * eye.height + (p - eye.foot).squaredNorm()));
            };
            if (near >= high - low)
                return graded(low, high, 2 * (high - low), n, add);
            if (nearest > low)
                graded(nearest, low, near, n, add);
            if (nearest < high)
                graded(nearest, high, near, n, add);
        });
    }
}

} // namespace penumbra
