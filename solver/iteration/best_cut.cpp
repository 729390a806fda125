#include "iteration/best_cut.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace penumbra {

namespace {

/// A line through a point of one side of a polygon and a point of another.
struct SideToSide {
    std::array<std::size_t, 2> side;
    std::array<double, 2> at; ///< along the sides, in (0, 1)
};

struct Scored {
    SideToSide where{};
    CutPlan plan;
    double score = 0; ///< squared error removed per coefficient added
};

class Search {
public:
    Search(const Element &node, const SampledField &field)
        : node_(node), field_(field), now_(misfit(field, node.basis.quad(), node.basis.order())) {}

    std::optional<CutPlan> run() {
        const std::size_t n_sides = node_.basis.outline().size();
        for (std::size_t i = 0; i < n_sides; ++i)
            for (std::size_t j = i + 1; j < n_sides; ++j)
                for (const double s : coarse)
                    for (const double t : coarse)
                        consider({{i, j}, {s, t}});
        if (!best_)
            return std::nullopt;
        for (double step = 0.125; step >= 1.0 / 32; step /= 2) {
            const SideToSide from = best_->where;
            for (const std::size_t end : {0u, 1u})
                for (const double by : {-step, step}) {
                    SideToSide moved = from;
                    moved.at[end] = std::clamp(from.at[end] + by, 0.02, 0.98);
                    consider(moved);
                }
        }
        return best_->plan;
    }

private:
    static constexpr std::array<double, 4> coarse{0.125, 0.375, 0.625, 0.875};

    void consider(const SideToSide &where) {
        const Polygon &outline = node_.basis.outline();
        const auto point = [&](std::size_t end) -> Vec2 {
            const Vec2 &from = outline[where.side[end]], &to = outline[(where.side[end] + 1) % outline.size()];
            return from + where.at[end] * (to - from);
        };
        const Vec2 p = point(0), d = (point(1) - p).normalized();
        std::optional<CutPlan> plan = plan_cut(node_, {-d.y(), d.x(), cross(p, d)});
        if (!plan)
            return;
        const std::vector<BilinearQuad> leaves = plan->leaves();
        const int order = node_.basis.order();
        const double added = static_cast<double>((leaves.size() - 1) * static_cast<std::size_t>(order * order));
        const double score = (now_ - misfit(field_, leaves, order)) / added;
        if (score > (best_ ? best_->score : 0)) {
            plan->half_depth = 1;
            best_ = Scored{where, std::move(*plan), score};
        }
    }

    const Element &node_;
    const SampledField &field_;
    double now_;
    std::optional<Scored> best_;
};

} // namespace

std::optional<CutPlan> best_cut(const Element &node, const SampledField &field) { return Search(node, field).run(); }

} // namespace penumbra
