#include "iteration/link_xray.h"

#include "iteration/link_fit.h"
#include "iteration/oracle.h"
#include "transport/integrate_links.h"
#include "transport/proximity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace penumbra {

namespace {

constexpr double near_share = 0.05;   // of the breadth
constexpr double exact_accuracy = 1e-6;
constexpr double drawn_in = 1e-3;     // of the line: on a border T may have no value

/// The part of the line at + s way inside a convex polygon; empty where low >= high.
struct Part {
    double low, high;
};
Part inside(const Polygon &convex, const Vec2 &at, const Vec2 &way) {
    Part part{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; k < convex.size(); ++k) {
        const Vec2 &corner = convex[k], side = convex[(k + 1) % convex.size()] - corner;
        const double depth = cross(side, at - corner), slope = cross(side, way);
        if (std::abs(slope) <= 1e-14 * side.norm())
            continue;
        if (slope > 0)
            part.low = std::max(part.low, -depth / slope);
        else
            part.high = std::min(part.high, -depth / slope);
    }
    return part;
}

/// Along the longer of the lines that join the middles of opposite sides, of the element or of the box about it.
Vec2 longer_direction(const ElementBasis &basis) {
    const BilinearQuad quad = basis.product_quad();
    const Vec2 a = quad.at(1, 0.5) - quad.at(0, 0.5), b = quad.at(0.5, 1) - quad.at(0.5, 0);
    return (a.norm() >= b.norm() ? a : b).normalized();
}

double breadth(const Polygon &polygon, const Vec2 &way) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec2 &p : polygon) {
        low = std::min(low, cross(way, p));
        high = std::max(high, cross(way, p));
    }
    return high - low;
}

} // namespace

LinkXray xray(const Setting &setting, const State &state, const Oracle &oracle, ElementId picked,
              const Interaction &interaction, XrayLine line, const Cancel *cancel) {
    const Scene &scene = *setting.scene;
    const Element &p = state.forest[interaction.receiver];
    const Surface &to = scene.surface(p.surface), &from = scene.surface(interaction.source);
    Transport transport = setting.transport(state.counters.threshold, cancel);
    transport.accuracy = std::min(transport.accuracy, exact_accuracy);

    std::vector<Vec2> tests;
    if (!interaction.weak)
        tests = oracle_points(transport, p, interaction, corner_distance(p, to, from));
    const auto missed = interaction.misfits(state.forest, state.radiosity);
    const Rgb rho = scene.reflectance(p.surface);
    Eigen::Index worst = -1, channel = 0;
    if (missed.rows() > 0) {
        const Eigen::MatrixX3d reflected = missed.cwiseAbs() * rho.matrix().asDiagonal();
        reflected.maxCoeff(&worst, &channel);
    } else {
        rho.maxCoeff(&channel);
    }

    const bool through_worst = line == XrayLine::worst && worst >= 0;
    const Vec2 centre = through_worst ? tests[static_cast<std::size_t>(worst)] : state.forest[picked].basis.centre();
    const Vec2 way = longer_direction(p.basis);
    const Part part = inside(p.basis.outline(), centre, way);
    const double size = scene.own.size;
    const Vec2 begin = centre + part.low * way;

    LinkXray out;
    out.line = through_worst ? XrayLine::worst : XrayLine::centre;
    out.from = scene.own.to_own(to.frame.to_space(begin));
    out.to = scene.own.to_own(to.frame.to_space(centre + part.high * way));
    if (const Part own = inside(state.forest[picked].basis.outline(), centre, way); own.low < own.high) {
        out.low = size * (own.low - part.low);
        out.high = size * (own.high - part.low);
    }
    out.passes = oracle.allowance().misfit(p);
    out.mean_square = oracle.allowance().mean_square();
    out.channel = static_cast<int>(channel);

    std::vector<Vec2> places;
    const double length = part.high - part.low;
    for (int k = 0; k < n_xray_points; ++k)
        places.push_back(begin + length * (drawn_in + (1 - 2 * drawn_in) * k / (n_xray_points - 1)) * way);
    places.insert(places.end(), tests.begin(), tests.end());
    Work uncounted;
    const auto exact = sample(transport, state.forest, interaction, places, state.radiosity, uncounted, SourceColumns::all);
    const LinkFit fit(state.forest, interaction, state.radiosity);
    const auto point = [&](std::size_t i) {
        return XrayPoint{size * (places[i] - begin).dot(way),
                         rho * exact.row(static_cast<Eigen::Index>(i)).transpose().array(), rho * fit.at(places[i])};
    };
    const double near = near_share * breadth(p.basis.outline(), way);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i < n_xray_points) {
            out.points.push_back(point(i));
            continue;
        }
        const double off = std::abs(cross(way, places[i] - begin));
        out.tests.push_back({point(i), size * off, off <= near, static_cast<Eigen::Index>(i) - n_xray_points == worst});
    }
    return out;
}

} // namespace penumbra
