#include "iteration/candidates.h"

#include "discontinuity/tolerance.h"
#include "iteration/sampled_field.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

constexpr double small = 0.25;        // of the node's area: a piece that is sampled on its own
constexpr std::size_t most_cuts = 24; // of one node that are scored, the longest first

struct CurveCut {
    CurveSegment segment; // inside the node
    CutPlan plan;

    double length() const { return (segment.to - segment.from).norm(); }
    HalfPlane line() const {
        const Vec2 d = (segment.to - segment.from).normalized();
        return {-d.y(), d.x(), cross(segment.from, d)};
    }
};

/// Cuts along the curves of the failing sources; curves that part nothing from the node are counted.
std::vector<CurveCut> curve_cuts(const Setting &setting, const Element &node,
                                 std::span<const Interaction *const> failing, int &n_along_sides) {
    std::vector<CurveCut> cuts;
    std::vector<SurfaceId> sources;
    for (const Interaction *interaction : failing)
        sources.push_back(interaction->source);
    for (const CurveSegment &segment : setting.curves.crossing(node.surface, node.basis.outline(), sources)) {
        CurveCut candidate{segment, {}};
        if (auto plan = plan_cut(node, candidate.line())) {
            candidate.plan = std::move(*plan);
            cuts.push_back(std::move(candidate));
        } else {
            ++n_along_sides;
        }
    }
    std::ranges::stable_sort(cuts, std::greater<>(), &CurveCut::length);
    if (cuts.size() > most_cuts)
        cuts.resize(most_cuts);
    return cuts;
}

/// Ends that the cut moved onto corners, and other curves that run along it: they will be sides of the children.
int n_snapped(const std::vector<CurveCut> &cuts, const CurveCut &made) {
    const HalfPlane line = made.line();
    const auto along = [&](const CurveCut &c) {
        return &c != &made && std::abs(line.value(c.segment.from)) < 2 * coincidence &&
               std::abs(line.value(c.segment.to)) < 2 * coincidence;
    };
    return made.plan.n_snapped + static_cast<int>(std::ranges::count_if(cuts, along));
}

} // namespace

std::optional<Split> best_split(const Setting &setting, const Transport &transport, const State &state, ElementId id,
                                std::span<const Interaction *const> failing, Work &work) {
    const Element &node = state.forest[id];
    const bool may_subdivide = node.half_depth + 2 <= 2 * setting.options.max_depth;
    std::vector<CurveCut> cuts;
    int n_along_sides = 0;
    if (cuts_along_curves(setting.options.strategy))
        cuts = curve_cuts(setting, node, failing, n_along_sides);
    std::optional<Split> best;
    if (may_subdivide)
        best.emplace();
    const CurveCut *made = nullptr;
    if (cuts.size() == 1 && !may_subdivide) {
        made = &cuts.front();
        best.emplace();
    } else if (!cuts.empty()) {
        const int order = node.basis.order();
        std::vector<BilinearQuad> small_pieces;
        for (const CurveCut &candidate : cuts)
            for (const BilinearQuad &piece : candidate.plan.leaves())
                if (piece.area() < small * node.basis.area())
                    small_pieces.push_back(piece);
        const SampledField field = sample_field(setting, transport, state, node, failing, small_pieces, work);
        const double now = misfit(field, node.basis.quad(), order);
        const auto score = [&](std::span<const BilinearQuad> children) {
            const double added = static_cast<double>((children.size() - 1) * static_cast<std::size_t>(order * order));
            return (now - misfit(field, children, order)) / added;
        };
        if (may_subdivide)
            best->score = score(uniform_children(node.basis.quad()));
        for (const CurveCut &candidate : cuts)
            if (const double value = score(candidate.plan.leaves()); !best || value > best->score) {
                made = &candidate;
                best = Split{{}, {}, value};
            }
    }
    if (best)
        work.snapped_cuts += n_along_sides;
    if (made) {
        best->cut = made->plan;
        best->curve = made->segment.curve;
        work.snapped_cuts += n_snapped(cuts, *made);
    }
    return best;
}

} // namespace penumbra
