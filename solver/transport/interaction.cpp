#include "transport/interaction.h"

#include "transport/integrate_links.h"
#include "transport/lambert.h"
#include "transport/lit_points.h"
#include "transport/point_transfer.h"
#include "transport/proximity.h"
#include "transport/variation.h"
#include "visibility/shaft.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {

namespace {

std::vector<Vec3> to_space(const PlaneFrame &frame, std::span<const Vec2> polygon) {
    std::vector<Vec3> out;
    for (const Vec2 &p : polygon)
        out.push_back(frame.to_space(p));
    return out;
}

/// The part of a polygon (all convex parts of a surface, or an element) in front of a plane, as the corners of its hull.
Polygon in_front(std::span<const Polygon> parts, const PlaneFrame &own, const PlaneFrame &plane) {
    const HalfPlane front{plane.normal.dot(own.u), plane.normal.dot(own.v), plane.height(own.origin)};
    Polygon all, inside, outside;
    for (const Polygon &part : parts) {
        split(part, front, inside, outside);
        all.insert(all.end(), inside.begin(), inside.end());
    }
    return parts.size() > 1 ? convex_hull(std::move(all)) : all;
}

auto radiosity_of(const Forest &forest, const Link &link, const Coefficients &radiosity) {
    return radiosity.middleRows(forest[link.source].first, link.kernel.cols());
}

} // namespace

Eigen::Matrix<double, Eigen::Dynamic, 3> Interaction::misfits(const Forest &forest, const Coefficients &radiosity) const {
    Eigen::Matrix<double, Eigen::Dynamic, 3> sum(links.empty() ? 0 : links[0].misfit.rows(), 3);
    sum.setZero();
    for (const Link &link : links)
        sum += link.misfit * radiosity_of(forest, link, radiosity);
    return sum;
}

Rgb Interaction::largest_misfit(const Forest &forest, const Coefficients &radiosity) const {
    const auto all = misfits(forest, radiosity);
    return all.rows() == 0 ? Rgb(Rgb::Zero()) : Rgb(all.cwiseAbs().colwise().maxCoeff().transpose().array());
}

Rgb Interaction::mean_square_misfit(const Forest &forest, const Coefficients &radiosity) const {
    const auto all = misfits(forest, radiosity);
    return all.rows() == 0 ? Rgb(Rgb::Zero()) : Rgb(all.array().square().colwise().mean().transpose());
}

Rgb Interaction::left_out(const Forest &forest, const Coefficients &radiosity) const {
    Rgb sum = Rgb::Zero();
    for (const Link &link : links)
        if (const Eigen::Index n = link.left_out.size(); n > 0)
            sum += (link.left_out.transpose() * radiosity.middleRows(forest[link.source].first + 1, n).cwiseAbs())
                       .transpose()
                       .array();
    return sum;
}

double form_factor_bound(const Transport &transport, const Element &p, SurfaceId source) {
    const Surface &receiver = transport.scene.surface(p.surface), &s = transport.scene.surface(source);
    double most = 0;
    const Vec2 centre = p.basis.centre();
    std::vector<Vec2> points{centre};
    for (const Vec2 &corner : p.basis.outline())
        points.push_back(corner + 1e-3 * (centre - corner));
    const auto lit = lit_points(p, receiver, s);
    points.insert(points.end(), lit.begin(), lit.end());
    ConvexPieces whole, front;
    for (const Polygon &part : s.parts)
        whole.add(part);
    for (const Vec2 &point : points) {
        const Vec3 x = receiver.frame.to_space(point);
        if (s.frame.height(x) <= 0)
            continue;
        const Vec3 &n = receiver.frame.normal;
        clip(whole, {n.dot(s.frame.u), n.dot(s.frame.v), n.dot(s.frame.origin - x)}, front);
        double sum = 0;
        for (std::size_t i = 0; i < front.size(); ++i)
            sum += lambert(x, n, s.frame, front[i]);
        most = std::max(most, sum);
    }
    return most;
}

Candidates all_candidates(const Transport &transport, SurfaceId receiver, SurfaceId source) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const SurfaceId s : {receiver, source})
        for (const Vec3 &x : transport.scene.surface(s).corners) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
    Candidates out;
    for (const int b : transport.blockers.near_box(low, high)) {
        const SurfaceId s = transport.blockers[b].surface;
        if (s == receiver || s == source)
            continue;
        out.blockers.push_back({b, false});
        out.n_proposed += !transport.blockers.edge_on(b, receiver);
    }
    out.n_proposed += transport.blockers.n_left_out_near(low, high, receiver, source);
    return out;
}

std::shared_ptr<const Interaction> connect(const Transport &transport, const Forest &forest, ElementId receiver,
                                           SurfaceId source, const Candidates &candidates,
                                           std::span<const ElementId> sources, const Leeway &leeway, Work &work,
                                           const Interaction *before, Fit fit) {
    const Element &p = forest[receiver];
    const Surface &to = transport.scene.surface(p.surface), &from = transport.scene.surface(source);
    auto out = std::make_shared<Interaction>();
    out->receiver = receiver;
    out->source = source;
    out->fit = fit;
    out->kind = PairKind::hidden;
    out->n_proposed = candidates.n_proposed;
    if (transport.clip_by_all)
        out->clipped_by = candidates.blockers;

    const std::vector<Polygon> element{p.basis.outline()};
    const Polygon p_front = in_front(element, to.frame, from.frame), s_front = in_front(from.parts, from.frame, to.frame);
    if (p_front.size() < 3 || s_front.size() < 3)
        return out;
    const std::vector<Vec3> p_space = to_space(to.frame, p_front), s_space = to_space(from.frame, s_front);
    const Shaft shaft(p_space, to.frame, s_space, from.frame);
    for (PairBlocker b : candidates.blockers) {
        const Blocker &blocker = transport.blockers[b.blocker];
        if (shaft.misses(blocker.corners))
            continue;
        if (!transport.link_hidden && spans_shaft(blocker.corners, blocker.frame, p_space, s_space)) {
            work.spared[Effect::hidden_pairs] += static_cast<std::int64_t>(sources.size());
            return out;
        }
        if (blocker.solid >= 0 && !b.front_only)
            b.front_only = transport.blockers.outside(blocker.solid, p_space);
        if (b.front_only &&
            std::ranges::all_of(p_space, [&](const Vec3 &x) { return blocker.frame.height(x) <= 0; }))
            continue;
        out->blockers.push_back(b);
    }

    const double distance = corner_distance(p, to, from);
    const double size = radius(p.basis.outline());
    const bool near = distance < 0.25 * size;
    out->kind = !out->blockers.empty() ? PairKind::partly_hidden : near ? PairKind::near : PairKind::clear;
    out->form_factor = out->variation = form_factor_bound(transport, p, source);
    if (out->kind == PairKind::clear)
        out->variation = std::min(out->form_factor, variation_bound(forest, p, to, from, sources, out->form_factor));
    out->weak = out->variation <= leeway.weak;

    integrate_links(transport, forest, *out, sources, fit.fine ? Leeway() : leeway, distance, before, work);
    return out;
}

Eigen::Matrix<double, Eigen::Dynamic, 3> sample(const Transport &transport, const Forest &forest,
                                                const Interaction &interaction, std::span<const Vec2> points,
                                                const Coefficients &radiosity, Work &work, SourceColumns columns) {
    const Element &p = forest[interaction.receiver];
    std::vector<SourceNode> nodes;
    for (const Link &link : interaction.links) {
        nodes.push_back(source_node(transport.scene, forest[link.source]));
        if (columns == SourceColumns::linked)
            nodes.back().n_columns = static_cast<int>(link.kernel.cols());
    }
    PointTransfer transfer(transport, p, interaction, std::move(nodes), work);
    Eigen::Matrix<double, Eigen::Dynamic, 3> out(static_cast<Eigen::Index>(points.size()), 3);
    std::vector<double> row(static_cast<std::size_t>(transfer.n_columns()));
    for (std::size_t i = 0; i < points.size(); ++i) {
        transfer.at(points[i], row);
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        Eigen::Index first = 0;
        for (const SourceNode &node : transfer.nodes()) {
            const Eigen::Map<const Eigen::RowVectorXd> part(row.data() + first, node.n_columns);
            sum += part * radiosity.middleRows(node.element.first, node.n_columns);
            first += node.n_columns;
        }
        out.row(static_cast<Eigen::Index>(i)) = sum;
    }
    return out;
}

} // namespace penumbra
