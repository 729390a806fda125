#include "measure/direct.h"

#include "basis/gauss.h"
#include "core/parallel.h"
#include "measure/cone_blockers.h"
#include "transport/lambert.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace penumbra {

Rgb direct_irradiance(const Scene &scene, const Blockers &blockers, SurfaceId id, const Vec2 &point, Work &work,
                      const HiddenPairs *hidden) {
    const Surface &surface = scene.surface(id);
    Rgb irradiance = Rgb::Zero();
    if (is_covered(surface, point))
        return irradiance;
    const Vec3 x = surface.frame.to_space(point);
    std::vector<PairBlocker> others;
    VisibleScratch scratch;
    for (int s = 0; s < scene.n_surfaces(); ++s) {
        const Surface &source = scene.surface(SurfaceId(s));
        if (s == id.index || !scene.emits(SurfaceId(s)) || source.frame.height(x) <= 0 ||
            behind(surface.frame, source.corners) || (hidden && hidden->hidden(SurfaceId(s), id)))
            continue;
        for (const Polygon &part : source.parts) {
            blockers_in_cone(x, surface.frame, source.frame, part, blockers, nullptr, others);
            scratch.hidden.cast(x, source.frame, blockers, others, work);
            ConvexPieces whole, rest;
            whole.add(part);
            for (const Polygon &cover : source.covers) {
                subtract(whole, half_planes(cover), rest);
                std::swap(whole, rest);
            }
            visible_part(x, surface.frame.normal, source.frame, whole, scratch.hidden, scratch);
            work.kernel_evaluations += static_cast<std::int64_t>(scratch.pieces.size());
            for (std::size_t i = 0; i < scratch.pieces.size(); ++i)
                irradiance += scene.exitance(SurfaceId(s)) *
                              lambert(x, surface.frame.normal, source.frame, scratch.pieces[i]);
        }
    }
    return irradiance;
}

Rgb direct_radiosity(const Scene &scene, const Blockers &blockers, SurfaceId id, const Vec2 &point) {
    Work work;
    if (is_covered(scene.surface(id), point))
        return Rgb::Zero();
    return scene.exitance(id) + scene.reflectance(id) * direct_irradiance(scene, blockers, id, point, work);
}

double direct_error(const Scene &scene, const Blockers &blockers, const Forest &forest, const Coefficients &radiosity) {
    struct Sums {
        double error = 0, reflected = 0;
    };
    std::vector<ElementId> leaves;
    std::vector<double> root_area(forest.elements.size());
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
        if (!scene.reflects(SurfaceId(s)))
            continue;
        for (const ElementId root : forest.roots[s])
            for_each_leaf(forest, root, [&](ElementId leaf) {
                leaves.push_back(leaf);
                root_area[leaf.at()] = forest[root].basis.area();
            });
    }
    const GaussRule &rule = gauss_rule(4);
    std::vector<Sums> sums(leaves.size());
    parallel_for(leaves.size(), [&](std::size_t l) {
        const Element &e = forest[leaves[l]];
        const double share =
            std::sqrt(e.basis.area() / (root_area[leaves[l].at()] * static_cast<double>(e.basis.n_tiles())));
        const int n_cells = std::max(2, static_cast<int>(std::ceil(40 * share)));
        const auto own = radiosity.middleRows(e.first, e.basis.n_functions());
        const auto add = [&](const QuadraturePoint &q, double weight) {
            if (is_covered(scene.surface(e.surface), q.position))
                return;
            const Rgb exact = direct_radiosity(scene, blockers, e.surface, q.position);
            const Rgb ours = (e.basis.evaluate(q).transpose() * own).transpose().array();
            sums[l].error += q.area * weight * (ours - exact).square().sum();
            sums[l].reflected += q.area * weight * (exact - scene.exitance(e.surface)).square().sum();
        };
        for (std::size_t tile = 0; tile < e.basis.n_tiles(); ++tile)
            for (int i = 0; i < n_cells; ++i)
                for (int j = 0; j < n_cells; ++j)
                    for (std::size_t a = 0; a < rule.points.size(); ++a)
                        for (std::size_t b = 0; b < rule.points.size(); ++b)
                            add(e.basis.at_parameters(tile, (i + rule.points[a]) / n_cells, (j + rule.points[b]) / n_cells),
                                rule.weights[a] * rule.weights[b] / (n_cells * n_cells));
    });
    Sums total;
    for (const Sums &s : sums) {
        total.error += s.error;
        total.reflected += s.reflected;
    }
    return total.reflected > 0 ? std::sqrt(total.error / total.reflected) : 0;
}

} // namespace penumbra
