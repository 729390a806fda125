#include "iteration/candidates.h"

#include "discontinuity/tolerance.h"
#include "hierarchy/planar_split.h"
#include "iteration/best_cut.h"
#include "iteration/sampled_field.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

constexpr double small = 0.25;        // of the node's area: a piece that is sampled on its own
constexpr double smallest_area = 1e-10; // of a node that is split on the way to a tolerance; the scene's diagonal is 1
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

/// What a uniform split is judged by: the four quarters. A bisection of the planar family is judged by the quarters that
/// its halves would become: for the price of a cut it halves but one direction, and where the next one has to halve the
/// other, a score of its own lets it win against curves again and again.
std::vector<ElementBasis> quarters(const Element &node) {
    if (!node.basis.planar())
        return uniform_children(node);
    std::vector<ElementBasis> out;
    for (const PlanarPiece &half : bisected(node.basis.planar()->domain, node.sides))
        for (const PlanarPiece &quarter : bisected(half.domain, half.sides))
            out.emplace_back(node.basis.order(), quarter.domain);
    return out;
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
    if (options.tolerance && node.basis.area() < smallest_area)
        return std::nullopt;
    const bool may_subdivide = node.half_depth + uniform_half_depth(node.basis) <= 2 * options.max_depth;
    const bool may_cut = cuts_along_curves(options.strategy);
    const bool may_bisect = node.half_depth + 1 <= 2 * options.max_depth;
    const bool may_cut_anywhere = may_cut && options.cut == CutChoice::best && may_bisect;
    std::vector<CurveCut> cuts;
    int n_along_sides = 0;
    if (may_cut)
        cuts = curve_cuts(*state.curves, node, failing, n_along_sides);
    if (cuts.empty() && !may_cut_anywhere)
        return may_subdivide ? std::optional(Split{}) : std::nullopt;

    std::vector<ElementBasis> small_pieces;
    for (const CurveCut &candidate : cuts)
        for (const ElementBasis &piece : candidate.plan.leaves())
            if (piece.area() < small * node.basis.area())
                small_pieces.push_back(piece);
    const SampledField field = sample_field(setting, transport, state, node, failing, small_pieces, work);
    const double now = misfit(field, node.basis);
    const auto gain = [&](std::span<const ElementBasis> children) { return now - misfit(field, children); };
    const auto added = [&](std::span<const ElementBasis> children) {
        return static_cast<double>(children.size() - 1) * node.basis.n_functions();
    };
    const double least = options.least_gain * allowed * options.least_gain * allowed * node.basis.area();

    std::optional<Split> best;
    if (may_subdivide) {
        const auto children = quarters(node);
        best = Split{{}, {}, gain(children) / added(children)};
    }
    const CurveCut *made = nullptr;
    int n_worth = 0;
    for (const CurveCut &candidate : cuts) {
        const std::vector<ElementBasis> children = candidate.plan.leaves();
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
            const std::vector<ElementBasis> children = plan->leaves();
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
