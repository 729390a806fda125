#include "measure/reference.h"

#include "core/parallel.h"
#include "measure/direct.h"
#include "measure/reflected_gather.h"
#include "visibility/blockers.h"

#include <cmath>
#include <utility>

namespace penumbra {

Reference::Reference(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)), blockers_(std::make_unique<const Blockers>(*scene_)) {}

Reference::Reference(std::shared_ptr<const Scene> scene, ConvergedSolution solution)
    : scene_(std::move(scene)), blockers_(std::make_unique<const Blockers>(*scene_)), forest_(std::move(solution.forest)),
      gather_(std::make_unique<const ReflectedGather>(*scene_, *blockers_, *forest_, std::move(solution.radiosity))),
      error_(solution.error) {}

Reference::~Reference() = default;
Reference::Reference(Reference &&) noexcept = default;

Rgb Reference::radiosity_at(SurfaceId surface, const Vec2 &point) const {
    Work work;
    return radiosity_at(surface, point, work);
}

Rgb Reference::radiosity_at(SurfaceId id, const Vec2 &point, Work &work) const {
    const Surface &surface = scene_->surface(id);
    if (is_covered(surface, point))
        return Rgb::Zero();
    Rgb irradiance = direct_irradiance(*scene_, *blockers_, id, point, work);
    if (gather_)
        irradiance += gather_->irradiance(id, point, work);
    return scene_->exitance(id) + scene_->reflectance(id) * irradiance;
}

double error_against(const Reference &reference, const Scene &scene, const Field &judged, int n_points,
                     const Cancel *cancel) {
    ResidualSampling sampling;
    sampling.n_batches = 1;
    sampling.n_points = n_points;
    const std::vector<ResidualPoint> points = std::move(draw_points(scene, judged, sampling).front());
    struct Squares {
        double error = 0, reflected = 0;
    };
    std::vector<Squares> squares(points.size());
    parallel_for(points.size(), [&](std::size_t i) {
        if (cancel)
            cancel->check();
        const ResidualPoint &p = points[i];
        const Rgb exact = reference.radiosity_at(p.surface, p.at) - scene.exitance(p.surface);
        squares[i] = {p.area * (p.solution - exact).square().sum(), p.area * exact.square().sum()};
    });
    Squares sum;
    for (const Squares &s : squares) {
        sum.error += s.error;
        sum.reflected += s.reflected;
    }
    return sum.reflected > 0 ? std::sqrt(sum.error / sum.reflected) : 0;
}

} // namespace penumbra
