// Three walls that meet in a corner, solved by another Galerkin method: a fixed mesh, all pairs of elements linked by
// brute quadrature, the system solved at once. No hierarchy, no closed form, no oracle.
#include "reference/faces.h"

#include "iteration/solver.h"

#include <Eigen/LU>
#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace penumbra {
namespace {

/// A unit square origin + s u + t v that looks along u x v.
struct Wall {
    Vec3 origin, u, v;
    double reflectance, exitance;

    Vec3 normal() const { return u.cross(v); }
    Vec3 at(double s, double t) const { return origin + s * u + t * v; }
};

// Each has two sides on the others; the corner of the three is 0.
const std::array<Wall, 3> walls{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.8, 0},
                                 {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.3, 1},
                                 {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0.6, 0.1}}};

/// Piecewise products of Legendre polynomials of degree < order on n x n squares of every wall.
class DenseGalerkin {
public:
    DenseGalerkin(int n, int order) : n_(n), order_(order), coefficients_(solve()) {}

    double radiosity(int wall, double s, double t) const {
        const int i = std::min(n_ - 1, static_cast<int>(s * n_)), j = std::min(n_ - 1, static_cast<int>(t * n_));
        return functions(s * n_ - i, t * n_ - j).dot(coefficients_.segment(first(wall, i, j), order_ * order_));
    }

private:
    int first(int wall, int i, int j) const { return ((wall * n_ + i) * n_ + j) * order_ * order_; }

    Eigen::VectorXd functions(double s, double t) const {
        const auto legendre = [](int k, double x) {
            return std::sqrt(2 * k + 1) * std::legendre(static_cast<unsigned>(k), 2 * x - 1);
        };
        Eigen::VectorXd values(order_ * order_);
        for (int a = 0; a < order_; ++a)
            for (int b = 0; b < order_; ++b)
                values[a * order_ + b] = legendre(a, s) * legendre(b, t);
        return values;
    }

    template <class Visit>
    static void for_each_gauss_point(const Visit &visit) {
        using Gauss = boost::math::quadrature::gauss<double, 6>;
        for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
            for (const double sign : {-1.0, 1.0})
                visit((1 + sign * Gauss::abscissa()[i]) / 2, Gauss::weights()[i] / 2);
    }

    /// Integral of G N_j over the cell [s, s + h] x [t, t + h] of a wall as seen from x: in quarters until the cell is
    /// no wider than it is far.
    void add_cell(const Vec3 &x, const Vec3 &normal, const Wall &q, double s, double t, double h, int i, int j,
                  Eigen::VectorXd &sum) const {
        const Vec3 to_centre = q.at(s + h / 2, t + h / 2) - x;
        if (to_centre.norm() < 1.5 * h) {
            for (const double ds : {0.0, h / 2})
                for (const double dt : {0.0, h / 2})
                    add_cell(x, normal, q, s + ds, t + dt, h / 2, i, j, sum);
            return;
        }
        for_each_gauss_point([&](double a, double wa) {
            for_each_gauss_point([&](double b, double wb) {
                const double u = s + h * a, v = t + h * b;
                const Vec3 d = q.at(u, v) - x;
                const double r2 = d.squaredNorm();
                const double g = std::max(0.0, normal.dot(d)) * std::max(0.0, -q.normal().dot(d)) / (std::numbers::pi * r2 * r2);
                sum += wa * wb * h * h * g * functions(u * n_ - i, v * n_ - j);
            });
        });
    }

    Eigen::VectorXd solve() const {
        const int size = 3 * n_ * n_ * order_ * order_, block = order_ * order_;
        Eigen::MatrixXd system = Eigen::MatrixXd::Identity(size, size);
        Eigen::VectorXd emitted = Eigen::VectorXd::Zero(size);
        Eigen::VectorXd moments(block);
        for (int p = 0; p < 3; ++p)
            for (int i = 0; i < n_; ++i)
                for (int j = 0; j < n_; ++j) {
                    const Wall &wall = walls[static_cast<std::size_t>(p)];
                    emitted[first(p, i, j)] = wall.exitance;
                    for_each_gauss_point([&](double a, double wa) {
                        for_each_gauss_point([&](double b, double wb) {
                            const Vec3 x = wall.at((i + a) / n_, (j + b) / n_);
                            const Eigen::VectorXd tested = wall.reflectance * wa * wb * functions(a, b);
                            for (int q = 0; q < 3; ++q)
                                for (int k = 0; k < n_ && q != p; ++k)
                                    for (int l = 0; l < n_; ++l) {
                                        moments.setZero();
                                        add_cell(x, wall.normal(), walls[static_cast<std::size_t>(q)],
                                                 static_cast<double>(k) / n_, static_cast<double>(l) / n_, 1.0 / n_, k, l, moments);
                                        system.block(first(p, i, j), first(q, k, l), block, block) -=
                                            tested * moments.transpose();
                                    }
                        });
                    });
                }
        return system.partialPivLu().solve(emitted);
    }

    int n_, order_;
    Eigen::VectorXd coefficients_;
};

/// Relative L2 difference of two radiosities over all walls, at midpoints of a grid that fits neither mesh.
template <class A, class B>
double difference(const A &a, const B &b) {
    constexpr int n = 45;
    double squares = 0, whole = 0;
    for (int w = 0; w < 3; ++w)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double s = (i + 0.5) / n, t = (j + 0.5) / n, x = a(w, s, t), y = b(w, s, t);
                squares += (x - y) * (x - y);
                whole += y * y;
            }
    return std::sqrt(squares / whole);
}

std::shared_ptr<const Scene> corner() {
    std::vector<reference::Face> faces;
    for (const Wall &w : walls)
        faces.push_back({{w.at(0, 0), w.at(1, 0), w.at(1, 1), w.at(0, 1)},
                         Rgb::Constant(w.reflectance),
                         Rgb::Constant(w.exitance)});
    return reference::scene_of(faces);
}

/// Radiosity at a point of a wall.
double radiosity_at(const Snapshot &snapshot, int wall, double s, double t) {
    const SnapshotSurface &plane = snapshot.surfaces[static_cast<std::size_t>(wall)];
    const Vec3 d = walls[static_cast<std::size_t>(wall)].at(s, t) - plane.origin;
    const Vec2 p(d.dot(plane.u), d.dot(plane.v));
    for (const SnapshotPatch &patch : snapshot.patches)
        if (patch.surface == wall && contains(patch.corners, p))
            return radiosity(snapshot, patch, p).x();
    ADD_FAILURE() << "no patch at " << s << ", " << t << " of wall " << wall;
    return 0;
}

TEST(DenseGalerkin, TheReferenceAgreesWithItself) {
    const DenseGalerkin coarse(3, 3), fine(6, 3);
    const double off = difference([&](int w, double s, double t) { return coarse.radiosity(w, s, t); },
                                  [&](int w, double s, double t) { return fine.radiosity(w, s, t); });
    EXPECT_LT(off, 6e-3);
}

TEST(DenseGalerkin, AgreesWithTheHierarchicalSolution) {
    const DenseGalerkin dense(6, 3);
    for (const int order : {3, 4}) {
        Options options;
        options.strategy = Strategy::uniform_wavelet;
        options.order = order;
        options.threshold = 0.004;
        Solver solver(corner(), options);
        EXPECT_TRUE(solver.run());
        const auto snapshot = solver.snapshot();
        const double off = difference([&](int w, double s, double t) { return radiosity_at(*snapshot, w, s, t); },
                                      [&](int w, double s, double t) { return dense.radiosity(w, s, t); });
        EXPECT_LT(off, 4e-3) << "order " << order;
    }
}

} // namespace
} // namespace penumbra
