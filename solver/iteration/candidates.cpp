#include "iteration/candidates.h"

#include "discontinuity/tolerance.h"
#include "iteration/best_cut.h"
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
std::vector<CurveCut> curve_cuts(const CurveIndex &curves, const Element &node,
                                 std::span<const Interaction *const> failing, int &n_along_sides) {
    std::vector<CurveCut> cuts;
    std::vector<SurfaceId> sources;
    for (const Interaction *interaction : failing)
        sources.push_back(interaction->source);
    for (const CurveSegment &segment : curves.crossing(node.surface, node.basis.outline(), sources)) {
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
                                std::span<const Interaction *const> failing, double allowed, Work &work) {
    const Element &node = state.forest[id];
    const Options &options = setting.options;
    const bool may_subdivide = node.half_depth + 2 <= 2 * options.max_depth;
    const bool may_cut = cuts_along_curves(options.strategy);
    const bool may_bisect = node.half_depth + 1 <= 2 * options.max_depth;
    const bool may_cut_anywhere = may_cut && options.cut == CutChoice::best && may_bisect;
    std::vector<CurveCut> cuts;
    int n_along_sides = 0;
    if (may_cut)
        cuts = curve_cuts(*state.curves, node, failing, n_along_sides);
    if (cuts.empty() && !may_cut_anywhere)
        return may_subdivide ? std::optional(Split{}) : std::nullopt;

    const int order = node.basis.order();
    std::vector<BilinearQuad> small_pieces;
    for (const CurveCut &candidate : cuts)
        for (const BilinearQuad &piece : candidate.plan.leaves())
            if (piece.area() < small * node.basis.area())
                small_pieces.push_back(piece);
    const SampledField field = sample_field(setting, transport, state, node, failing, small_pieces, work);
    const double now = misfit(field, node.basis.quad(), order);
    const auto gain = [&](std::span<const BilinearQuad> children) { return now - misfit(field, children, order); };
    const auto added = [&](std::span<const BilinearQuad> children) {
        return static_cast<double>((children.size() - 1) * static_cast<std::size_t>(order * order));
    };
    const double least = options.least_gain * allowed * options.least_gain * allowed * node.basis.area();

    std::optional<Split> best;
    if (may_subdivide) {
        const auto children = uniform_children(node.basis.quad());
        best = Split{{}, {}, gain(children) / added(children)};
    }
    const CurveCut *made = nullptr;
    int n_worth = 0;
    for (const CurveCut &candidate : cuts) {
        const std::vector<BilinearQuad> children = candidate.plan.leaves();
        const double removed = gain(children), score = removed / added(children);
        if (removed < least)
            continue;
        ++n_worth;
        if (!best || score > best->score) {
            made = &candidate;
            best = Split{candidate.plan, candidate.segment.curve, score};
        }
    }
    if (n_worth == 0 && may_cut_anywhere)
        if (auto plan = best_cut(node, field)) {
            const std::vector<BilinearQuad> children = plan->leaves();
            if (const double score = gain(children) / added(children); !best || score > best->score)
                best = Split{std::move(plan), {}, score};
        }
    if (best)
        work.snapped_cuts += n_along_sides + (made ? n_snapped(cuts, *made) : 0);
    if (!node.at_limit)
        work.left_out_curves += static_cast<int>(cuts.size()) - n_worth;
    return best;
}

} // namespace penumbra
