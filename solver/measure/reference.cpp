#include "measure/reference.h"

#include "core/parallel.h"
#include "measure/cone_blockers.h"
#include "measure/direct.h"
#include "transport/point_transfer.h"
#include "transport/source_moments.h"
#include "visibility/blockers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace penumbra {

namespace {

// An element stands for its children where what it leaves out of them brings less than this, as a fraction of the
// largest radiosity that was reflected.
constexpr double least_detail = 1e-5;
constexpr double moments_accuracy = 1e-6;

/// No less than the form factor from x to what lies in front of it of the polygon.
double form_factor_limit(const Vec3 &x, const PlaneFrame &source, const Polygon &polygon, double area) {
    const double height = source.height(x);
    const Vec2 foot = source.to_plane(x);
    const double distance2 = height * height + (nearest_point(polygon, foot) - foot).squaredNorm();
    return std::min(1.0, area / (std::numbers::pi * std::max(distance2, 1e-300)));
}

} // namespace

/// The reflected light of a solution, B_h - E, as a source.
struct Reference::Gather {
    std::shared_ptr<const Forest> forest;
    Coefficients reflected;          ///< B_h - E
    std::vector<double> detail;      ///< dropped_detail / the largest
    std::vector<SourceNode> nodes;   ///< by element; of reflecting surfaces

    Gather(const Scene &scene, std::shared_ptr<const Forest> of, Coefficients radiosity)
        : forest(std::move(of)), reflected(std::move(radiosity)) {
        double largest = 0;
        for (const Element &e : forest->elements) {
            reflected.row(e.first) -= scene.exitance(e.surface).matrix().transpose();
            nodes.push_back(source_node(scene, e));
            if (e.leaf())
                largest = std::max(largest, reflected.row(e.first).maxCoeff());
        }
        detail = dropped_detail(*forest, reflected);
        for (double &d : detail)
            d /= std::max(largest, 1e-300);
    }

    Rgb irradiance(const Scene &scene, const Blockers &blockers, SurfaceId id, const Vec3 &x, Work &work) const;
};

Rgb Reference::Gather::irradiance(const Scene &scene, const Blockers &blockers, SurfaceId id, const Vec3 &x,
                                  Work &work) const {
    const PlaneFrame &receiver = scene.surface(id).frame;
    std::vector<PairBlocker> of_root, of_node;
    std::vector<ElementId> waiting;
    VisibleScratch scratch;
    Rgb sum = Rgb::Zero();
    for (int s = 0; s < scene.n_surfaces(); ++s) {
        const Surface &source = scene.surface(SurfaceId(s));
        if (s == id.index || !scene.reflects(SurfaceId(s)) || source.frame.height(x) <= 0 ||
            behind(receiver, source.corners))
            continue;
        for (const ElementId root : forest->roots[static_cast<std::size_t>(s)]) {
            blockers_in_cone(x, receiver, source.frame, (*forest)[root].basis.outline(), blockers, nullptr, of_root);
            waiting.assign(1, root);
            while (!waiting.empty()) {
                const ElementId id_here = waiting.back();
                const Element &e = (*forest)[id_here];
                waiting.pop_back();
                if (!e.leaf() && detail[id_here.at()] * form_factor_limit(x, source.frame, e.basis.outline(), e.basis.area()) >
                                     least_detail) {
                    for (int c = 0; c < e.n_children; ++c)
                        waiting.emplace_back(e.first_child.index + c);
                    continue;
                }
                blockers_in_cone(x, receiver, source.frame, e.basis.outline(), blockers, &of_root, of_node);
                scratch.hidden.cast(x, source.frame, blockers, of_node, work);
                visible_part(x, receiver.normal, source.frame, nodes[id_here.at()].whole, scratch.hidden, scratch);
                std::array<double, max_functions> moments{};
                const int n = e.basis.n_functions();
                source_moments(x, receiver.normal, source.frame, e.basis, scratch.pieces, moments_accuracy,
                               std::span(moments).first(static_cast<std::size_t>(n)), work);
                const auto b = reflected.middleRows(e.first, n);
                sum += Rgb((Eigen::Map<const Eigen::RowVectorXd>(moments.data(), n) * b).transpose().array());
            }
        }
    }
    return sum;
}

Reference::Reference(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)), blockers_(std::make_unique<const Blockers>(*scene_)) {}

Reference::Reference(std::shared_ptr<const Scene> scene, ConvergedSolution solution)
    : scene_(std::move(scene)), blockers_(std::make_unique<const Blockers>(*scene_)),
      gather_(std::make_unique<const Gather>(*scene_, std::move(solution.forest), std::move(solution.radiosity))),
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
        irradiance += gather_->irradiance(*scene_, *blockers_, id, surface.frame.to_space(point), work);
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
