#include "reference/kernel_integrals.h"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace penumbra::reference {

namespace {

struct Rule {
    std::vector<double> points, weights; // on [0, 1]
};

template <unsigned N>
Rule rule() {
    using Gauss = boost::math::quadrature::gauss<double, N>;
    Rule out;
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
        for (const double sign : {-1.0, 1.0}) {
            const double x = Gauss::abscissa()[i];
            if (x == 0 && sign > 0)
                continue;
            out.points.push_back((1 + sign * x) / 2);
            out.weights.push_back(Gauss::weights()[i] / 2);
        }
    return out;
}

Rule rule(int n) {
    switch (n) {
    case 7:
        return rule<7>();
    case 10:
        return rule<10>();
    case 15:
        return rule<15>();
    case 20:
        return rule<20>();
    case 25:
        return rule<25>();
    case 30:
        return rule<30>();
    default:
        throw std::invalid_argument("no such rule");
    }
}

double legendre(int k, double t) { return std::sqrt(2 * k + 1) * std::legendre(static_cast<unsigned>(k), 2 * t - 1); }

Eigen::VectorXd legendre_all(int order, double t) {
    Eigen::VectorXd values(order);
    for (int k = 0; k < order; ++k)
        values[k] = legendre(k, t);
    return values;
}

/// The integral over s of N_i(s) N_j(s - w), s on p and s - w on q: a polynomial of w between the overlaps' ends.
Eigen::MatrixXd along_line(const HingedRectangle &p, const HingedRectangle &q, double w, int order) {
    static const Rule gauss = rule(7);
    const double low = std::max(std::min(p.from, p.to), std::min(q.from, q.to) + w);
    const double high = std::min(std::max(p.from, p.to), std::max(q.from, q.to) + w);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(order, order);
    for (std::size_t k = 0; k < gauss.points.size() && low < high; ++k) {
        const double s = low + (high - low) * gauss.points[k];
        sum += gauss.weights[k] * (high - low) * legendre_all(order, (s - p.from) / (p.to - p.from)) *
               legendre_all(order, (s - w - q.from) / (q.to - q.from)).transpose();
    }
    return sum;
}

} // namespace

Eigen::MatrixXd hinged_kernel(const HingedRectangle &p, const HingedRectangle &q, double angle, int order, int n) {
    const Rule gauss = rule(n);
    const std::size_t count = gauss.points.size();
    const double sine = std::sin(angle), cosine = std::cos(angle);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(order * order, order * order);

    // One point (w, a, b) with its weight; `along` is the polynomial of w.
    const auto add = [&](double w, double a, double b, double weight, const Eigen::MatrixXd &along) {
        const double r2 = w * w + a * a + b * b - 2 * a * b * cosine;
        const double g = weight * a * b * sine * sine / (std::numbers::pi * r2 * r2);
        const Eigen::MatrixXd away =
            g * legendre_all(order, a / p.reach) * legendre_all(order, b / q.reach).transpose();
        for (int i = 0; i < order; ++i)
            for (int j = 0; j < order; ++j)
                sum.block(i * order, j * order, order, order) += along(i, j) * away;
    };

    std::vector<double> ends{p.from - q.from, p.from - q.to, p.to - q.from, p.to - q.to, 0.0};
    std::ranges::sort(ends);
    for (std::size_t e = 0; e + 1 < ends.size(); ++e) {
        double near = ends[e], far = ends[e + 1];
        if (far - near < 1e-14)
            continue;
        if (std::abs(far) < std::abs(near))
            std::swap(near, far);
        const double width = std::abs(far - near);
        for (std::size_t i = 0; i < count; ++i) {
            const double x = gauss.points[i];
            if (near != 0) {
                const Eigen::MatrixXd along = along_line(p, q, near + (far - near) * x, order);
                for (std::size_t j = 0; j < count; ++j)
                    for (std::size_t k = 0; k < count; ++k)
                        add(near + (far - near) * x, p.reach * gauss.points[j], q.reach * gauss.points[k],
                            width * p.reach * q.reach * gauss.weights[i] * gauss.weights[j] * gauss.weights[k], along);
                continue;
            }
            // The cube as three pyramids with their tips in the pole: w, a or b is the largest coordinate x.
            const Eigen::MatrixXd largest = along_line(p, q, far * x, order);
            for (std::size_t j = 0; j < count; ++j) {
                const double y = gauss.points[j] * x;
                const Eigen::MatrixXd smaller = along_line(p, q, far * y, order);
                for (std::size_t k = 0; k < count; ++k) {
                    const double z = gauss.points[k] * x;
                    const double weight =
                        width * p.reach * q.reach * x * x * gauss.weights[i] * gauss.weights[j] * gauss.weights[k];
                    add(far * x, p.reach * y, q.reach * z, weight, largest);
                    add(far * y, p.reach * x, q.reach * z, weight, smaller);
                    add(far * y, p.reach * z, q.reach * x, weight, smaller);
                }
            }
        }
    }
    return sum / (std::abs(p.to - p.from) * p.reach);
}

Eigen::MatrixXd clear_kernel(const Parallelogram &p, const Parallelogram &q, int order, int panels) {
    const Rule gauss = rule(10);
    const auto points = static_cast<Eigen::Index>(gauss.points.size()) * panels;
    Eigen::VectorXd at(points), weight(points);
    Eigen::MatrixXd functions(order, points);
    for (Eigen::Index k = 0; k < points; ++k) {
        const auto i = static_cast<std::size_t>(k / panels);
        at[k] = (static_cast<double>(k % panels) + gauss.points[i]) / panels;
        weight[k] = gauss.weights[i] / panels;
        functions.col(k) = legendre_all(order, at[k]);
    }
    const Vec3 area_p = p.first.cross(p.second), area_q = q.first.cross(q.second), n = area_p.normalized();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(order * order, order * order);
    for (Eigen::Index a = 0; a < points; ++a)
        for (Eigen::Index b = 0; b < points; ++b) {
            const Vec3 x = p.corner + at[a] * p.first + at[b] * p.second;
            // By one parameter of the source after the other.
            Eigen::MatrixXd from(order, order);
            from.setZero();
            for (Eigen::Index c = 0; c < points; ++c) {
                Eigen::VectorXd inner = Eigen::VectorXd::Zero(order);
                for (Eigen::Index d = 0; d < points; ++d) {
                    const Vec3 r = q.corner + at[c] * q.first + at[d] * q.second - x;
                    const double r2 = r.squaredNorm();
                    inner += weight[d] * r.dot(n) * -r.dot(area_q) / (std::numbers::pi * r2 * r2) * functions.col(d);
                }
                from += weight[c] * functions.col(c) * inner.transpose();
            }
            for (int i = 0; i < order; ++i)
                for (int j = 0; j < order; ++j)
                    for (int k = 0; k < order; ++k)
                        sum.block(i * order + j, k * order, 1, order) +=
                            weight[a] * weight[b] * functions(i, a) * functions(j, b) * from.row(k);
        }
    return sum;
}

} // namespace penumbra::reference
