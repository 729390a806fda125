#include "reference/solution.h"

#include <cmath>

namespace penumbra::reference {

namespace {

template <class Value>
double root_mean_square(const Scene &scene, const Forest &roots, const Value &value) {
    constexpr int n = 48;
    double squares = 0, area = 0;
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
        if (!scene.reflects(SurfaceId(s)))
            continue;
        for (const ElementId root : roots.roots[s])
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const QuadraturePoint q = roots[root].basis.at_parameters((i + 0.5) / n, (j + 0.5) / n);
                    if (is_covered(scene.surfaces[s], q.position))
                        continue;
                    squares += q.area * value(SurfaceId(s), q.position).square().sum();
                    area += q.area;
                }
    }
    return std::sqrt(squares / area);
}

} // namespace

Rgb radiosity_at(const State &state, SurfaceId surface, const Vec2 &p) {
    const Forest &forest = state.forest;
    const auto holds = [&](ElementId e) { return contains(forest[e].basis.outline(), p, 1e-12); };
    for (const ElementId root : forest.roots[surface.at()]) {
        ElementId e = root;
        while (holds(e) && !forest[e].leaf()) {
            ElementId below = forest[e].first_child;
            for (int c = 1; c < forest[e].n_children && !holds(below); ++c)
                below = ElementId(below.index + 1);
            if (!holds(below))
                break;
            e = below;
        }
        if (holds(e) && forest[e].leaf()) {
            const auto b = state.radiosity.middleRows(forest[e].first, forest[e].basis.n_functions());
            return (forest[e].basis.evaluate(p).transpose() * b).transpose().array();
        }
    }
    return Rgb::Zero();
}

double root_mean_square_difference(const Scene &scene, const State &a, const State &b) {
    return root_mean_square(scene, a.forest, [&](SurfaceId s, const Vec2 &p) -> Rgb {
        return radiosity_at(a, s, p) - radiosity_at(b, s, p);
    });
}

double root_mean_square_reflected(const Scene &scene, const State &a) {
    return root_mean_square(
        scene, a.forest, [&](SurfaceId s, const Vec2 &p) -> Rgb { return radiosity_at(a, s, p) - scene.exitance(s); });
}

} // namespace penumbra::reference
