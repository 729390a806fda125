#include "study/health.h"

#include "core/parallel.h"
#include "visibility/ray_scene.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace penumbra {

namespace {

struct Flux {
    Rgb emitted = Rgb::Zero();  ///< by the emitters
    Rgb leaving = Rgb::Zero();  ///< B over all surfaces
    Rgb absorbed = Rgb::Zero(); ///< by the reflecting surfaces, as the solution has it
    double escaped = 0;         ///< of the rays, those that meet nothing
    Rgb arrives = Rgb::Zero();  ///< irradiance over the reflecting surfaces, as the solution has it
    Rgb by_rays = Rgb::Zero();  ///< the same, as rays bring it

    Flux &operator+=(const Flux &o) {
        emitted += o.emitted;
        leaving += o.leaving;
        absorbed += o.absorbed;
        escaped += o.escaped;
        arrives += o.arrives;
        by_rays += o.by_rays;
        return *this;
    }
};

/// A channel in which a surface does not reflect tells nothing of what arrives there: it counts as black.
Rgb reflecting(const Rgb &rho) { return (rho > 0).cast<double>(); }

/// Follows `n` rays from a leaf: points and cosine-weighted directions from a four-dimensional Kronecker sequence
/// (multiples of powers of the root of x^5 = x + 1).
Flux follow(const Scene &scene, const RayScene &rays, const Element &e, const Coefficients &radiosity, int n,
            std::size_t seed) {
    constexpr double g = 1.1673039782614187;
    constexpr std::array<double, 4> step{1 / g, 1 / (g * g), 1 / (g * g * g), 1 / (g * g * g * g)};
    const Surface &surface = scene.surface(e.surface);
    const Rgb &rho = scene.reflectance(e.surface), &own = scene.exitance(e.surface);
    const auto b = radiosity.middleRows(e.first, e.basis.n_functions());
    Flux flux;
    for (int k = 0; k < n; ++k) {
        std::array<double, 4> s;
        for (std::size_t d = 0; d < 4; ++d) {
            const double x = 0.5 + step[d] * static_cast<double>(k) + 0.7548776662466927 * static_cast<double>(seed % 4096);
            s[d] = x - std::floor(x);
        }
        // One sequence over all tiles.
        const double n_tiles = static_cast<double>(e.basis.n_tiles()), tile = std::floor(s[0] * n_tiles);
        const QuadraturePoint q = e.basis.at_parameters(static_cast<std::size_t>(tile), s[0] * n_tiles - tile, s[1]);
        const double area = n_tiles * q.area / n;
        const bool dark = is_covered(surface, q.position);
        const Rgb value = dark ? Rgb(Rgb::Zero()) : Rgb((e.basis.evaluate(q).transpose() * b).transpose().array());
        flux.leaving += area * value;
        if (!dark) {
            flux.emitted += area * own;
            flux.arrives += reflecting(rho) * area * (value - own) / rho.max(1e-300);
            flux.absorbed += reflecting(rho) * (1 - rho) * area * (value - own) / rho.max(1e-300);
        }
        const double r = std::sqrt(s[2]), phi = 2 * std::numbers::pi * s[3];
        const Vec3 direction = r * std::cos(phi) * surface.frame.u + r * std::sin(phi) * surface.frame.v +
                               std::sqrt(1 - s[2]) * surface.frame.normal;
        const auto hit = rays.nearest(surface.frame.to_space(q.position), direction);
        if (!hit || !hit->front) {
            ++flux.escaped;
            continue;
        }
        const Surface &target = scene.surface(hit->surface);
        const Vec3 at = surface.frame.to_space(q.position) + hit->distance * direction;
        if (!is_covered(target, target.frame.to_plane(at)))
            flux.by_rays += reflecting(scene.reflectance(hit->surface)) * area * value;
    }
    return flux;
}

double least_radiosity(const Element &e, const Coefficients &radiosity) {
    const auto b = radiosity.middleRows(e.first, e.basis.n_functions());
    double least = std::numeric_limits<double>::infinity();
    for (const BilinearQuad &tile : e.basis.tiles())
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 5; ++j)
                least = std::min(
                    least, (e.basis.evaluate(tile.at((i + 0.5) / 5, (j + 0.5) / 5)).transpose() * b).minCoeff());
    return least;
}

double largest_gram_error(const Forest &forest) {
    double most = 0;
    for (const Element &e : forest.elements) {
        const int n = e.basis.n_functions();
        Eigen::MatrixXd gram = -Eigen::MatrixXd::Identity(n, n);
        for (const QuadraturePoint &q : e.basis.quadrature(e.basis.order() + 1)) {
            const BasisValues values = e.basis.evaluate(q);
            gram += q.inner * values * values.transpose();
        }
        most = std::max(most, gram.cwiseAbs().maxCoeff());
    }
    return most;
}

/// Of the surfaces that have elements to receive.
double largest_closure_error(const Scene &scene, const State &state) {
    double most = 0;
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
        if (!scene.reflects(SurfaceId(s)))
            continue;
        double sum = 0, area = 0;
        for (const ElementId root : state.forest.roots[s])
            area += state.forest[root].basis.area();
        for (std::size_t e = 0; e < state.interactions.size(); ++e)
            for (const auto &interaction : state.interactions[e])
                if (state.forest[interaction->receiver].surface == SurfaceId(s))
                    for (const Link &link : interaction->links)
                        sum += state.forest[interaction->receiver].basis.area() * link.kernel(0, 0);
        most = std::max(most, std::abs(sum / area - 1));
    }
    return most;
}

bool all_shine(const Forest &forest, const Coefficients &radiosity) {
    return std::ranges::all_of(forest.roots, [&](const std::vector<ElementId> &roots) {
        return std::ranges::any_of(
            roots, [&](ElementId root) { return radiosity.row(forest[root].first).maxCoeff() > 0; });
    });
}

double largest_condition(const Forest &forest) {
    std::set<const TwoScale *> seen;
    double most = 1;
    for (const Element &e : forest.elements)
        if (e.filters && seen.insert(e.filters.get()).second) {
            const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXd>(e.filters->push).singularValues();
            most = std::max(most, s[0] / s[s.size() - 1]);
        }
    return most;
}

} // namespace

Health health(const Scene &scene, const State &state, int n_rays) {
    const Forest &forest = state.forest;
    std::vector<std::size_t> leaves;
    std::vector<double> weights;
    double total = 0;
    Health out;
    out.min_radiosity = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < forest.elements.size(); ++i) {
        const Element &e = forest.elements[i];
        if (!e.leaf())
            continue;
        leaves.push_back(i);
        weights.push_back(e.basis.area() * state.radiosity.row(e.first).cwiseAbs().maxCoeff());
        total += weights.back();
        out.min_radiosity = std::min(out.min_radiosity, least_radiosity(e, state.radiosity));
    }
    const RayScene rays(scene);
    std::vector<Flux> fluxes(leaves.size());
    parallel_for(leaves.size(), [&](std::size_t l) {
        const int n = 16 + static_cast<int>(n_rays * (total > 0 ? weights[l] / total : 0.0));
        fluxes[l] = follow(scene, rays, forest.elements[leaves[l]], state.radiosity, n, l);
    });
    Flux sum;
    for (const Flux &f : fluxes)
        sum += f;
    if (sum.emitted.maxCoeff() > 0) {
        out.energy_balance_error = (sum.arrives - sum.by_rays).abs().maxCoeff() / sum.emitted.maxCoeff();
        out.absorbed = sum.absorbed.sum() / sum.emitted.sum();
        out.lost = (sum.leaving - sum.by_rays).sum() / sum.emitted.sum();
        out.drift = 1 - out.absorbed - out.lost;
    }
    const bool closed = sum.escaped == 0 && all_shine(forest, state.radiosity);
    out.closure_error = closed ? largest_closure_error(scene, state) : std::numeric_limits<double>::quiet_NaN();
    out.max_gram_error = largest_gram_error(forest);
    out.max_filter_condition = largest_condition(forest);
    out.non_finite = static_cast<int>((!state.radiosity.array().isFinite()).count());
    return out;
}

} // namespace penumbra
