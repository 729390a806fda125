// What links of lower order leave out: the bound for constants against the worst light there can be, and links of a
// solution against the light that their sources really bring.
#include "analytic/links.h"
#include "iteration/allowance.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"
#include "transport/link_orders.h"
#include "transport/variation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace penumbra {
namespace {

struct Patch {
    Vec3 corner, first, second;

    Vec3 at(double s, double t) const { return corner + s * first + t * second; }
    Vec3 normal() const { return first.cross(second).normalized(); }
    double area() const { return first.cross(second).norm(); }
    reference::Face face() const { return {{at(0, 0), at(1, 0), at(1, 1), at(0, 1)}}; }
};

double kernel(const Patch &p, const Vec3 &x, const Patch &q, const Vec3 &y) {
    const Vec3 d = y - x;
    return std::max(0.0, p.normal().dot(d)) * std::max(0.0, -q.normal().dot(d)) /
           (std::numbers::pi * d.squaredNorm() * d.squaredNorm());
}

/// The most that constants miss at any point of p, over all radiosities 0 <= b <= 1 of q: with the mean F of the form
/// factor over p it is the integral over q of the positive (or of the negative) part of G(x,y) - F / |q|.
double worst_light(const Patch &p, const Patch &q) {
    constexpr int n = 12;
    std::array<std::array<double, n * n>, n * n> g{};
    double mean = 0;
    for (int i = 0; i < n * n; ++i)
        for (int j = 0; j < n * n; ++j) {
            const auto middle = [](int k) { return std::pair((k / n + 0.5) / n, (k % n + 0.5) / n); };
            const auto [s, t] = middle(i);
            const auto [u, v] = middle(j);
            double &here = g[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            here = kernel(p, p.at(s, t), q, q.at(u, v));
            mean += here / (n * n * n * n);
        }
    double most = 0;
    for (const auto &row : g) {
        double above = 0, below = 0;
        for (const double value : row) {
            above += std::max(0.0, value - mean) * q.area() / (n * n);
            below += std::max(0.0, mean - value) * q.area() / (n * n);
        }
        most = std::max({most, above, below});
    }
    return most;
}

TEST(LinkOrders, NoLightVariesMoreThanTheBound) {
    std::mt19937 random(5);
    const auto in = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    std::vector<double> excess;
    for (int i = 0; i < 400; ++i) {
        const Patch p{Vec3::Zero(), Vec3::UnitX(), in(0.2, 1) * Vec3::UnitY()};
        const double distance = in(1, 12), lean = in(0, 1.4), turn = in(0, 6.28), tilt = in(-1, 1);
        const Vec3 away(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn), std::cos(lean));
        const Eigen::Matrix3d leaning = Eigen::AngleAxisd(tilt, Vec3(std::cos(turn), std::sin(turn), 0)).toRotationMatrix();
        const Patch q{distance * away, leaning * Vec3::UnitY() * in(0.2, 1), leaning * Vec3::UnitX()};
        const Pair pair(p.face(), q.face(), 1);
        const Transport transport{*pair.scene, pair.blockers};
        const Element &element = pair.forest[pair.forest.roots[0].at(0)];
        const double factor = form_factor_bound(transport, element, SurfaceId(1));
        if (factor <= 0)
            continue;
        const double bound = variation_bound(pair.forest, element, pair.scene->surface(SurfaceId(0)),
                                             pair.scene->surface(SurfaceId(1)), pair.forest.roots[1], factor);
        if (!std::isfinite(bound))
            continue;
        const double worst = worst_light(p, q);
        EXPECT_LE(worst, bound) << distance << ' ' << lean << ' ' << tilt;
        excess.push_back(bound / worst);
    }
    ASSERT_GT(excess.size(), 200U);
    std::ranges::sort(excess);
    EXPECT_LT(excess[excess.size() / 2], 20); // a bound that is never reached would leave nothing out
}

/// Of what passes at a node.
struct Shares {
    int n = 0;
    double squares = 0, most = 0;

    void add(double share) {
        ++n;
        squares += share * share;
        most = std::max(most, share);
    }
    double root_mean_square() const { return std::sqrt(squares / n); }
};

class LowerOrders : public testing::TestWithParam<BasisFamily> {};

TEST_P(LowerOrders, MissLittleOfWhatPasses) {
    const auto scene = std::make_shared<const Scene>(open_scene("table", {}));
    Options options = Options().to_tolerance(0.01);
    options.basis = GetParam();
    Solver solver(scene, options);
    ASSERT_TRUE(solver.run());
    const State &state = *solver.state();
    Setting setting;
    setting.scene = scene;
    setting.options = options;
    const Allowance allowance(setting, state);
    const Blockers blockers(*scene);
    const Transport transport{*scene, blockers, 1e-5};
    std::mt19937 random(7);
    Leeway norm;
    norm.mean_square = true;
    Shares missed, left_out; // by fits of lower order; by columns that are not there
    for (std::size_t e = 0; e < state.forest.elements.size(); ++e)
        for (const auto &interaction : state.interactions[e]) {
            const Element &p = state.forest.elements[e];
            const bool lower = interaction->order < p.basis.order();
            const bool without = std::ranges::any_of(interaction->links, [](const Link &l) { return l.left_out.size() > 0; });
            if (interaction->weak || (!lower && !without))
                continue;
            norm.reflectance = scene->reflectance(p.surface);
            std::vector<ElementId> sources;
            for (const Link &link : interaction->links)
                sources.push_back(link.source);
            Work work;
            const auto full = connect(transport, state.forest, ElementId(e), interaction->source,
                                      all_candidates(transport, p.surface, interaction->source), sources, {}, work);
            ASSERT_EQ(full->order, p.basis.order());
            std::vector<Vec2> points;
            for (int i = 0; i < 20; ++i)
                points.push_back(p.basis.at_parameters(0, random() / 4294967296.0, random() / 4294967296.0).position);
            const auto share = [&](const ChannelValues &part) { return size_of(part, norm) / allowance.misfit(p); };
            const ChannelValues brought = sample(transport, state.forest, *full, points, state.radiosity, work);
            if (without)
                left_out.add(share(brought - sample(transport, state.forest, *interaction, points, state.radiosity, work)));
            if (!lower)
                continue;
            ChannelValues fitted = ChannelValues::Zero(brought.rows(), 3);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const BasisValues at = p.basis.evaluate(points[i]);
                for (const Link &link : interaction->links) {
                    const auto b = state.radiosity.middleRows(state.forest[link.source].first, link.kernel.cols());
                    for (int k = 0; k < link.kernel.rows(); ++k)
                        fitted.row(static_cast<Eigen::Index>(i)) +=
                            at[p.basis.place(interaction->order, k)] * (link.kernel.row(k) * b);
                }
            }
            missed.add(share(brought - fitted));
        }
    EXPECT_GT(missed.n, 20);
    EXPECT_GT(left_out.n, 20);
    for (const Shares &part : {missed, left_out}) {
        EXPECT_LT(part.root_mean_square(), 0.1);
        EXPECT_LT(part.most, 0.4);
    }
}

INSTANTIATE_TEST_SUITE_P(Bases, LowerOrders, testing::Values(BasisFamily::parametric, BasisFamily::planar),
                         [](const auto &tested) { return std::string(name(tested.param)); });

} // namespace
} // namespace penumbra
