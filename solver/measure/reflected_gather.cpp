#include "measure/reflected_gather.h"

#include "measure/cone_blockers.h"
#include "transport/source_moments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace penumbra {

namespace {

/// No less than the form factor from x to what lies in front of it of the polygon.
double form_factor_limit(const Vec3 &x, const PlaneFrame &source, const Polygon &polygon, double area) {
    const double height = source.height(x);
    const Vec2 foot = source.to_plane(x);
    const double distance2 = height * height + (nearest_point(polygon, foot) - foot).squaredNorm();
    return std::min(1.0, area / (std::numbers::pi * std::max(distance2, 1e-300)));
}

/// sum_j>0 |b_j| max |N_j|, of the channel where it is largest. Orthonormal polynomials are largest at corners.
double largest_variation(const Element &e, const Coefficients &b) {
    BasisValues most = e.basis.evaluate(e.basis.centre()).cwiseAbs();
    for (const Vec2 &corner : e.basis.outline())
        most = most.cwiseMax(e.basis.evaluate(corner).cwiseAbs());
    most[0] = 0;
    return (most.transpose() * rows(e, b).cwiseAbs()).maxCoeff();
}

} // namespace

ReflectedGather::ReflectedGather(const Scene &scene, const Blockers &blockers, const Forest &forest,
                                 Coefficients radiosity, double accuracy)
    : scene_(scene), blockers_(blockers), forest_(forest), reflected_(std::move(radiosity)), accuracy_(accuracy) {
    double largest = 0;
    for (const Element &e : forest_.elements) {
        reflected_.row(e.first) -= scene_.exitance(e.surface).matrix().transpose();
        nodes_.push_back(source_node(scene_, e));
        if (e.leaf())
            largest = std::max(largest, reflected_.row(e.first).maxCoeff());
    }
    detail_ = dropped_detail(forest_, reflected_);
    largest = std::max(largest, 1e-300);
    for (double &d : detail_)
        d /= largest;
    for (const Element &e : forest_.elements)
        variation_.push_back(largest_variation(e, reflected_) / largest);
}

Rgb ReflectedGather::irradiance(SurfaceId id, const Vec2 &point, Work &work) const {
    const PlaneFrame &receiver = scene_.surface(id).frame;
    const Vec3 x = receiver.to_space(point);
    std::vector<PairBlocker> of_root, of_node;
    std::vector<ElementId> waiting;
    VisibleScratch scratch;
    Rgb sum = Rgb::Zero();
    for (int s = 0; s < scene_.n_surfaces(); ++s) {
        const Surface &source = scene_.surface(SurfaceId(s));
        if (s == id.index || !scene_.reflects(SurfaceId(s)) || source.frame.height(x) <= 0 ||
            behind(receiver, source.corners))
            continue;
        for (const ElementId root : forest_.roots[static_cast<std::size_t>(s)]) {
            blockers_in_cone(x, receiver, source.frame, forest_[root].basis.outline(), blockers_, nullptr, of_root);
            waiting.assign(1, root);
            while (!waiting.empty()) {
                const ElementId id_here = waiting.back();
                const Element &e = forest_[id_here];
                waiting.pop_back();
                const double form_factor = form_factor_limit(x, source.frame, e.basis.outline(), e.basis.area());
                if (!e.leaf() && detail_[id_here.at()] * form_factor > 10 * accuracy_) {
                    for (int c = 0; c < e.n_children; ++c)
                        waiting.emplace_back(e.first_child.index + c);
                    continue;
                }
                blockers_in_cone(x, receiver, source.frame, e.basis.outline(), blockers_, &of_root, of_node);
                scratch.hidden.cast(x, source.frame, blockers_, of_node, work);
                visible_part(x, receiver.normal, source.frame, nodes_[id_here.at()].whole, scratch.hidden, scratch);
                std::array<double, max_functions> moments{};
                const double allowed = accuracy_ / std::max(form_factor * variation_[id_here.at()], 1e-300);
                const int n = allowed < 1 ? e.basis.n_functions() : 1;
                source_moments(x, receiver.normal, source.frame, e.basis, scratch.pieces, std::clamp(allowed, accuracy_, 1e-2),
                               std::span(moments).first(static_cast<std::size_t>(n)), work);
                const auto b = reflected_.middleRows(e.first, n);
                sum += Rgb((Eigen::Map<const Eigen::RowVectorXd>(moments.data(), n) * b).transpose().array());
            }
        }
    }
    return sum;
}

} // namespace penumbra
