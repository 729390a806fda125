#include "reference/point_moments.h"

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>

namespace penumbra::reference {

namespace {

Digits pi() { return boost::math::constants::pi<Digits>(); }

struct Patch {
    std::array<Exact2, 4> corners;

    Exact2 at(const Digits &u, const Digits &v) const {
        return (corners[0] * (1 - u) + corners[1] * u) * (1 - v) + (corners[3] * (1 - u) + corners[2] * u) * v;
    }
};

/// The functions along a line x(u) = from + u step, whose second parameter is v: polynomials of u.
class Functions {
public:
    Functions(const ElementBasis &element, std::span<const Vec2> piece)
        : order_(static_cast<std::size_t>(element.order())) {
        if (const BilinearQuad *quad = element.quad()) {
            Patch whole;
            std::ranges::transform(quad->corners, whole.corners.begin(), [](const Vec2 &c) { return exact(c); });
            own_ = std::ranges::equal(piece, element.outline());
            if (own_) {
                patches_ = {whole};
                return;
            }
            const auto &c = whole.corners;
            set_frame(c[0], c[1] - c[0], c[3] - c[0]);
        } else {
            planar_ = true;
            const Affine &box = element.planar()->domain.to_plane();
            set_frame(exact(box.offset), exact(Vec2(box.linear.col(0))), exact(Vec2(box.linear.col(1))));
            orthonormalise(fan(element.outline()));
        }
        patches_ = fan(piece);
    }

    const std::vector<Patch> &patches() const { return patches_; }

    std::vector<ExactPolynomial> along(const Exact2 &from, const Exact2 &step, const Digits &v) const {
        if (own_) {
            const auto a = exact_legendre(0, 1), b = exact_legendre(v, 0);
            std::vector<ExactPolynomial> out;
            for (std::size_t i = 0; i < order_; ++i)
                for (std::size_t j = 0; j < order_; ++j)
                    out.push_back(a[i] * ExactPolynomial{b[j][0]});
            return out;
        }
        const std::vector<ExactPolynomial> raw = products(from, step);
        if (!planar_)
            return raw;
        std::vector<ExactPolynomial> out;
        for (std::size_t k = 0; k < raw.size(); ++k) {
            ExactPolynomial sum(order_, Digits(0));
            for (std::size_t l = 0; l <= k; ++l)
                for (std::size_t d = 0; d < raw[l].size(); ++d)
                    sum[d] += coefficients_[k][l] * raw[l][d];
            out.push_back(sum);
        }
        return out;
    }

private:
    static std::vector<Patch> fan(std::span<const Vec2> polygon) {
        std::vector<Patch> out;
        for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
            out.push_back({{exact(polygon[k]), exact(polygon[k + 1]), exact(polygon[0]), exact(polygon[0])}});
        return out;
    }

    void set_frame(const Exact2 &origin, const Exact2 &a, const Exact2 &b) {
        origin_ = origin;
        const Digits area = cross(a, b);
        to_s_ = {{b.at[1] / area, -b.at[0] / area}};
        to_t_ = {{-a.at[1] / area, a.at[0] / area}};
    }

    std::vector<ExactPolynomial> products(const Exact2 &from, const Exact2 &step) const {
        const auto a = exact_legendre(to_s_.dot(from - origin_), to_s_.dot(step));
        const auto b = exact_legendre(to_t_.dot(from - origin_), to_t_.dot(step));
        std::vector<ExactPolynomial> out;
        if (planar_) {
            for (std::size_t degree = 0; degree < order_; ++degree)
                for (std::size_t j = 0; j <= degree; ++j)
                    out.push_back(a[degree - j] * b[j]);
            return out;
        }
        for (std::size_t i = 0; i < order_; ++i)
            for (std::size_t j = 0; j < order_; ++j)
                out.push_back(a[i] * b[j]);
        return out;
    }

    /// Gram and Schmidt in the order of the products: the inverse of Cholesky's factor.
    void orthonormalise(const std::vector<Patch> &whole) {
        const ExactRule &rule = exact_gauss(8);
        std::vector<std::vector<Digits>> values;
        std::vector<Digits> weights;
        Digits area = 0;
        for (const Patch &p : whole)
            for (std::size_t i = 0; i < 8; ++i)
                for (std::size_t j = 0; j < 8; ++j) {
                    const Digits &u = rule.points[i], &v = rule.points[j];
                    std::vector<Digits> row;
                    for (const ExactPolynomial &f : products(p.at(u, v), {{Digits(0), Digits(0)}}))
                        row.push_back(f[0]);
                    values.push_back(row);
                    // A triangle: the Jacobian is that of its first side shrunk by 1 - v.
                    weights.push_back(rule.weights[i] * rule.weights[j] * (1 - v) *
                                      cross(p.corners[1] - p.corners[0], p.corners[2] - p.corners[0]));
                    area += weights.back();
                }
        const std::size_t n = values[0].size();
        const auto inner = [&](const std::vector<Digits> &a, const std::vector<Digits> &b) {
            Digits sum = 0;
            for (std::size_t p = 0; p < values.size(); ++p) {
                Digits fa = 0, fb = 0;
                for (std::size_t l = 0; l < n; ++l) {
                    fa += a[l] * values[p][l];
                    fb += b[l] * values[p][l];
                }
                sum += weights[p] * fa * fb / area;
            }
            return sum;
        };
        for (std::size_t k = 0; k < n; ++k) {
            std::vector<Digits> c(n, Digits(0));
            c[k] = 1;
            std::vector<Digits> shares;
            for (const auto &before : coefficients_)
                shares.push_back(inner(c, before));
            for (std::size_t b = 0; b < shares.size(); ++b)
                for (std::size_t l = 0; l < n; ++l)
                    c[l] -= shares[b] * coefficients_[b][l];
            const Digits norm = sqrt(inner(c, c));
            for (Digits &value : c)
                value /= norm;
            coefficients_.push_back(c);
        }
    }

    std::size_t order_;
    bool planar_ = false, own_ = false;
    std::vector<Patch> patches_;
    Exact2 origin_, to_s_, to_t_;
    std::vector<std::vector<Digits>> coefficients_;
};

/// The integrals of u^k / q^2 over [0, 1] for k < count, q = a u^2 + b u + c without real roots.
std::vector<Digits> over_squared_quadratic(const Digits &a, const Digits &b, const Digits &c, std::size_t count) {
    std::vector<Digits> out(count, Digits(0));
    const Digits q0 = c, q1 = a + b + c;
    // A short way: the recurrence would cancel, and a rule is exact to all digits that count.
    if (16 * a < std::min(q0, q1)) {
        const ExactRule &rule = exact_gauss(20);
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const Digits &u = rule.points[i], q = (a * u + b) * u + c;
            Digits term = rule.weights[i] / (q * q);
            for (Digits &sum : out) {
                sum += term;
                term *= u;
            }
        }
        return out;
    }
    const Digits d = 4 * a * c - b * b, root = sqrt(d);
    std::vector<Digits> over_q{2 * atan2(root, 2 * c + b) / root};
    over_q.push_back((log(q1 / q0) - b * over_q[0]) / (2 * a));
    for (std::size_t k = 0; k + 2 < count; ++k)
        over_q.push_back((1 / Digits(k + 1) - b * over_q[k + 1] - c * over_q[k]) / a);
    out[0] = ((2 * a + b) / q1 - b / q0 + 2 * a * over_q[0]) / d;
    out[1] = (2 - (b + 2 * c) / q1 - b * over_q[0]) / d;
    for (std::size_t k = 0; k + 2 < count; ++k)
        out[k + 2] = (over_q[k] - b * out[k + 1] - c * out[k]) / a;
    return out;
}

/// The receiver in the source's plane.
struct Eye {
    Exact2 foot;
    Digits height;        ///< above the plane, times |u x v|
    Exact3 base, u, v, n; ///< the frame's origin as seen from x

    Digits facing(const Exact2 &p) const { return n.dot(base + u * p.at[0] + v * p.at[1]); }
};

struct Integral {
    const Eye &eye;
    const Functions &functions;
    const Patch &patch;
    std::vector<Digits> sums{};

    void add_line(const Digits &v, const Digits &weight) {
        const auto &c = patch.corners;
        const Exact2 from = patch.at(0, v), step = patch.at(1, v) - from;
        const Exact2 across0 = c[3] - c[0], across1 = c[2] - c[1];
        const Digits j0 = cross(step, across0), j1 = cross(step, across1);
        const Digits f0 = eye.facing(from), f1 = eye.facing(patch.at(1, v));
        const ExactPolynomial common = ExactPolynomial{j0, j1 - j0} * ExactPolynomial{f0, f1 - f0};
        // |y - x|^2 with u and v as they are, not quite unit and orthogonal.
        const Exact3 a = eye.base + eye.u * from.at[0] + eye.v * from.at[1];
        const Exact3 s = eye.u * step.at[0] + eye.v * step.at[1];
        const std::vector<Digits> integrals = over_squared_quadratic(s.dot(s), 2 * s.dot(a), a.dot(a), 12);
        const Digits scale = weight * eye.height / pi();
        const auto all = functions.along(from, step, v);
        sums.resize(all.size(), Digits(0));
        for (std::size_t k = 0; k < all.size(); ++k) {
            const ExactPolynomial p = all[k] * common;
            Digits sum = 0;
            for (std::size_t d = 0; d < p.size(); ++d)
                sum += p[d] * integrals[d];
            sums[k] += scale * sum;
        }
    }
};

/// Where a line of constant v comes near the foot: v of the foot's nearest points on the sides u = 0 and u = 1, and of
/// the line through the foot itself.
std::vector<Digits> breaks_of(const Patch &patch, const Exact2 &foot) {
    std::vector<Digits> out{0, 1};
    const auto add = [&](const Digits &v) {
        if (v > 0 && v < 1)
            out.push_back(v);
    };
    const auto &c = patch.corners;
    for (const auto &[a, b] : {std::pair(c[0], c[3]), std::pair(c[1], c[2])})
        if (const Exact2 side = b - a; side.dot(side) > 0)
            add(side.dot(foot - a) / side.dot(side));
    // cross(at(1,v) - at(0,v), foot - at(0,v)) = k0 + k1 v + k2 v^2, by three values.
    const auto value = [&](const Digits &v) {
        const Exact2 from = patch.at(0, v);
        return cross(patch.at(1, v) - from, foot - from);
    };
    const Digits at0 = value(0), at1 = value(1), middle = value(Digits(0.5));
    const Digits k2 = 2 * (at0 + at1 - 2 * middle), k1 = at1 - at0 - k2;
    const Digits d = k1 * k1 - 4 * k2 * at0;
    if (d >= 0) {
        const Digits w = -(k1 + (k1 >= 0 ? sqrt(d) : Digits(-sqrt(d)))) / 2;
        if (w != 0)
            add(at0 / w);
        if (abs(k2) > 0)
            add(w / k2);
    }
    std::ranges::sort(out);
    return out;
}

/// Distance of x from the patch, over its size: what the panels are graded by.
double relative_distance(const Patch &patch, const Eye &eye) {
    Polygon corners;
    for (const Exact2 &c : patch.corners)
        if (const Vec2 p((c - eye.foot).at[0].convert_to<double>(), (c - eye.foot).at[1].convert_to<double>());
            corners.empty() || corners.back() != p)
            corners.push_back(p);
    const double off = nearest_point(corners, Vec2::Zero()).norm();
    return std::clamp(std::hypot(eye.height.convert_to<double>(), off) / (2 * radius(corners)), 1e-20, 1.0);
}

void integrate(Integral &integral, int n_points) {
    const double near = relative_distance(integral.patch, integral.eye);
    const ExactRule &rule = exact_gauss(n_points);
    const std::vector<Digits> breaks = breaks_of(integral.patch, integral.eye.foot);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const Digits half = (breaks[k + 1] - breaks[k]) / 2;
        if (half <= 0)
            continue;
        // From either end to the middle: v = end +- near sinh(w).
        const Digits scale = near, reach = asinh(half / scale);
        const int n_panels = static_cast<int>(std::ceil(reach.convert_to<double>() + 1e-9));
        for (int panel = 0; panel < n_panels; ++panel)
            for (std::size_t i = 0; i < rule.points.size(); ++i) {
                const Digits w = reach * (panel + rule.points[i]) / n_panels, step = scale * sinh(w);
                const Digits weight = rule.weights[i] * reach / n_panels * scale * cosh(w);
                integral.add_line(breaks[k] + step, weight);
                integral.add_line(breaks[k + 1] - step, weight);
            }
    }
}

} // namespace

std::vector<Digits> point_moments(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, const ElementBasis &element,
                                  std::span<const Vec2> piece, int n_points) {
    const Exact3 u = exact(source.u), v = exact(source.v), base = exact(source.origin) - exact(x);
    const Exact3 normal = cross(u, v);
    Eye eye{{{-base.dot(u) / u.dot(u), -base.dot(v) / v.dot(v)}}, -base.dot(normal), base, u, v, exact(n)};
    const Functions functions(element, piece);
    std::vector<Digits> sums;
    for (const Patch &patch : functions.patches()) {
        Integral integral{eye, functions, patch};
        integrate(integral, n_points);
        sums.resize(integral.sums.size(), Digits(0));
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += integral.sums[k];
    }
    return sums;
}

Digits exact_lambert(const Vec3 &x, const Vec3 &n, const PlaneFrame &source, std::span<const Vec2> polygon) {
    const Exact3 base = exact(source.origin) - exact(x);
    const auto towards = [&](const Vec2 &p) {
        return base + exact(source.u) * Digits(p.x()) + exact(source.v) * Digits(p.y());
    };
    Digits sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Exact3 a = towards(polygon[i]), b = towards(polygon[(i + 1) % polygon.size()]);
        const Exact3 normal = cross(b, a);
        const Digits sine = sqrt(normal.dot(normal));
        if (sine > 0)
            sum += atan2(sine, a.dot(b)) * normal.dot(exact(n)) / sine;
    }
    return sum / (2 * pi());
}

} // namespace penumbra::reference
