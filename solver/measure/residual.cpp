#include "measure/residual.h"

#include "core/parallel.h"
#include "core/random.h"
#include "measure/direct.h"
#include "measure/leaf_at.h"
#include "measure/reflected_gather.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace penumbra {

namespace {

/// Reflecting leaves, with the share of the points that falls on each.
struct Leaves {
    std::vector<ElementId> ids;
    std::vector<double> shares, cumulative; ///< cumulative[i]: of all before and leaf i

    Leaves(const Scene &scene, const Forest &forest) {
        double area = 0, n_at_limit = 0;
        for (std::size_t e = 0; e < forest.elements.size(); ++e)
            if (const Element &element = forest.elements[e]; element.leaf() && scene.reflects(element.surface)) {
                ids.emplace_back(e);
                area += element.basis.area();
                n_at_limit += element.at_limit;
            }
        const double by_limit = n_at_limit > 0 ? 0.25 : 0, by_leaf = 0.5 - by_limit;
        double sum = 0;
        for (const ElementId e : ids) {
            shares.push_back(0.5 * forest[e].basis.area() / area + by_leaf / static_cast<double>(ids.size()) +
                             (forest[e].at_limit ? by_limit / n_at_limit : 0));
            cumulative.push_back(sum += shares.back());
        }
    }
    std::size_t at(double t) const {
        const auto i = std::ranges::upper_bound(cumulative, t * cumulative.back()) - cumulative.begin();
        return std::min(static_cast<std::size_t>(i), ids.size() - 1);
    }
};

} // namespace

Rgb reflected_irradiance(const Solution &solution, SurfaceId id, const Vec2 &point, int n_strata, std::uint64_t seed,
                         std::uint64_t stream, Work &work) {
    const Scene &scene = solution.scene;
    const PlaneFrame &frame = scene.surface(id).frame;
    const Vec3 x = frame.to_space(point);
    Random random(seed, stream);
    Rgb sum = Rgb::Zero();
    for (int i = 0; i < n_strata; ++i)
        for (int j = 0; j < n_strata; ++j) {
            const double s = (i + random.next()) / n_strata, t = (j + random.next()) / n_strata;
            const double r = std::sqrt(s), phi = 2 * std::numbers::pi * t;
            const Vec3 direction =
                r * std::cos(phi) * frame.u + r * std::sin(phi) * frame.v + std::sqrt(1 - s) * frame.normal;
            const auto hit = solution.rays->nearest(x, direction);
            if (!hit || !hit->front || !scene.reflects(hit->surface))
                continue;
            const Surface &met = scene.surface(hit->surface);
            const Vec2 at = met.frame.to_plane(x + hit->distance * direction);
            if (!is_covered(met, at))
                sum += radiosity_at(solution.forest, solution.radiosity, hit->surface, at) - scene.exitance(hit->surface);
        }
    const int n_rays = n_strata * n_strata;
    work.rays += n_rays;
    return sum / n_rays;
}

std::vector<std::vector<ResidualPoint>> draw_points(const Scene &scene, const Field &judged,
                                                    const ResidualSampling &sampling) {
    const Leaves leaves(scene, judged.forest);
    const auto n = static_cast<std::size_t>(sampling.n_points);
    std::vector<std::vector<ResidualPoint>> batches(static_cast<std::size_t>(sampling.n_batches));
    if (leaves.ids.empty())
        return batches;
    for (std::size_t b = 0; b < batches.size(); ++b) {
        // Strata of equal share along the leaves, and in the leaves a Kronecker sequence (multiples of powers of the root
        // of x^3 = x + 1), both moved at random.
        constexpr double step_u = 0.7548776662466927, step_v = 0.5698402909980532;
        Random random(sampling.seed, b);
        const double move_u = random.next(), move_v = random.next();
        for (std::size_t k = 0; k < n; ++k) {
            const std::size_t l = leaves.at((static_cast<double>(k) + random.next()) / static_cast<double>(n));
            const Element &e = judged.forest[leaves.ids[l]];
            const double u = move_u + step_u * static_cast<double>(k), v = move_v + step_v * static_cast<double>(k);
            const double n_tiles = static_cast<double>(e.basis.n_tiles());
            const double along = (u - std::floor(u)) * n_tiles, tile = std::min(std::floor(along), n_tiles - 1);
            const QuadraturePoint q = e.basis.at_parameters(static_cast<std::size_t>(tile), along - tile, v - std::floor(v));
            if (is_covered(scene.surface(e.surface), q.position))
                continue;
            ResidualPoint point;
            point.surface = e.surface;
            point.at = q.position;
            point.area = q.area * n_tiles / (static_cast<double>(n) * leaves.shares[l]);
            const auto b_h = judged.radiosity.middleRows(e.first, e.basis.n_functions());
            point.solution = Rgb((e.basis.evaluate(q).transpose() * b_h).transpose().array()) - scene.exitance(e.surface);
            batches[b].push_back(point);
        }
    }
    return batches;
}

std::vector<std::vector<ResidualPoint>> sample_residual(const Solution &solution, const Field &judged,
                                                        const ResidualSampling &sampling, const Cancel *cancel,
                                                        Work &work) {
    const Scene &scene = solution.scene;
    std::vector<std::vector<ResidualPoint>> batches = draw_points(scene, judged, sampling);
    struct Place {
        std::size_t batch, point;
    };
    std::vector<Place> places;
    for (std::size_t b = 0; b < batches.size(); ++b)
        for (std::size_t k = 0; k < batches[b].size(); ++k)
            places.push_back({b, k});
    std::vector<Work> done(places.size());
    parallel_for(places.size(), [&](std::size_t i) {
        if (cancel)
            cancel->check();
        ResidualPoint &p = batches[places[i].batch][places[i].point];
        const Rgb &rho = scene.reflectance(p.surface);
        const Rgb direct = rho * direct_irradiance(scene, solution.blockers, p.surface, p.at, done[i], solution.hidden) - p.solution;
        p.first = p.second = direct;
        if (!solution.rays && !solution.gather)
            return;
        if (solution.gather) {
            p.first += rho * solution.gather->irradiance(p.surface, p.at, done[i]);
            p.second = p.first;
            return;
        }
        for (const auto &[gather, stream] : {std::pair(&p.first, 2 * i), std::pair(&p.second, 2 * i + 1)})
            *gather += rho * reflected_irradiance(solution, p.surface, p.at, sampling.n_strata,
                                                  mixed(sampling.seed + 1), stream, done[i]);
    });
    for (const Work &w : done)
        work += w;
    return batches;
}

} // namespace penumbra
