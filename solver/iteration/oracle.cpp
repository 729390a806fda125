#include "iteration/oracle.h"

#include "core/parallel.h"
#include "iteration/link_fit.h"

#include <algorithm>
#include <limits>

namespace penumbra {

namespace {

/// Shares of the oracle's threshold: a source brings too little to be tested below the first; sources are split until
/// what their pulls dropped brings less than the second.
constexpr double weak_share = 0.1, source_share = 0.5;
/// Of what passes at a node: what lower orders may miss when a link is made, and before it is made anew. Figures behind these:
/// tests/bench/README.md.
constexpr double order_share = 0.05, order_limit = 0.15;
/// Of what passes: how far below black a leaf that is kept may be, once it was damped.
constexpr double damping_share = 0.9;

} // namespace

Oracle::Oracle(const Setting &setting, const State &state)
    : setting_(setting), state_(state), scene_(*setting.scene), allowance_(setting, state),
      detail_(dropped_detail(state.forest, state.radiosity)), brightness_(scene_.surfaces.size()) {
    for (std::size_t s = 0; s < brightness_.size(); ++s)
        brightness_[s] = largest_radiosity(SurfaceId(s));
}

Rgb Oracle::largest_radiosity(SurfaceId s) const {
    Rgb most = Rgb::Zero();
    for (const ElementId root : state_.forest.roots[s.at()])
        for_each_leaf(state_.forest, root, [&](ElementId leaf) {
            const Element &e = state_.forest[leaf];
            const auto b = state_.radiosity.middleRows(e.first, e.basis.n_functions());
            most = most.max(b.row(0).transpose().array().abs());
            for (const Vec2 &corner : e.basis.outline())
                most = most.max((e.basis.evaluate(corner).transpose() * b).transpose().array().abs());
        });
    return most;
}

/// The form factor, or part of one, that brings too little to matter.
double Oracle::slack(ElementId receiver, SurfaceId source) const {
    const Rgb most = scene_.reflectance(state_.forest[receiver].surface) * brightness_[source.at()];
    return most.maxCoeff() > 0 ? weak_share * allowance_.anywhere() / most.maxCoeff()
                               : std::numeric_limits<double>::infinity();
}

Leeway Oracle::leeway(ElementId receiver, SurfaceId source) const {
    const Element &p = state_.forest[receiver];
    if (setting_.options.effects[Effect::order] == Switch::on)
        return {};
    return {slack(receiver, source), order_share * allowance_.misfit(p), allowance_.mean_square(),
            scene_.reflectance(p.surface), &state_.radiosity};
}

double Oracle::most_brought(const Interaction &interaction) const {
    const SurfaceId receiver = state_.forest[interaction.receiver].surface;
    return interaction.variation * (scene_.reflectance(receiver) * brightness(interaction.source)).maxCoeff();
}

double Oracle::weak_below() const { return weak_share * allowance_.anywhere(); }

Judgement Oracle::judge(const Interaction &interaction) const {
    Judgement out;
    const bool weak = interaction.variation <= leeway(interaction.receiver, interaction.source).weak;
    if (interaction.links.empty())
        return out;
    out.weak = interaction.weak && weak;
    if (out.weak)
        return out;
    const Element &p = state_.forest[interaction.receiver];
    const double rho = scene_.reflectance(p.surface).maxCoeff();
    double dropped = 0;
    for (const Link &link : interaction.links)
        dropped += rho * link.kernel(0, 0) * detail_[link.source.at()];
    bool split_source = false;
    const double share = source_share * allowance_.anywhere() / static_cast<double>(interaction.links.size());
    for (const Link &link : interaction.links) {
        const Element &q = state_.forest[link.source];
        const bool split = dropped > source_share * allowance_.anywhere() && !q.leaf() &&
                           rho * link.kernel(0, 0) * detail_[link.source.at()] > 0.5 * share;
        if (!split)
            out.sources.push_back(link.source);
        for (int c = 0; split && c < q.n_children; ++c)
            out.sources.push_back(ElementId(q.first_child.index + c));
        split_source |= split;
    }
    const double misfit = allowance_.measured(interaction, state_, scene_.reflectance(p.surface));
    // A threshold of 0 lets nothing pass once there is light.
    out.misfit = misfit > 0 ? misfit / allowance_.misfit(p) : 0;
    const double left_out = (scene_.reflectance(p.surface) * interaction.left_out(state_.forest, state_.radiosity)).maxCoeff();
    out.afresh = interaction.fit.damping == 1 && ((interaction.order < p.basis.order() && out.misfit > order_limit) ||
                                                  left_out > order_limit * allowance_.misfit(p));
    if (out.afresh)
        out.verdict = Verdict::relink;
    else if (out.misfit > 1)
        out.verdict = Verdict::fail;
    else if (split_source || (interaction.weak && !weak))
        out.verdict = Verdict::relink;
    return out;
}

std::vector<std::vector<Judgement>> Oracle::judge_all() const {
    std::vector<std::vector<Judgement>> judgements(state_.interactions.size());
    parallel_for(judgements.size(), [&](std::size_t e) {
        for (const auto &interaction : state_.interactions[e])
            judgements[e].push_back(judge(*interaction));
    });
    if (!allowance_.mean_square())
        judge_what_is_below_black(judgements);
    return judgements;
}

void Oracle::judge_what_is_below_black(std::vector<std::vector<Judgement>> &judgements) const {
    const double aim = damping_share * allowance_.anywhere();
    std::vector<Darkness> dark(judgements.size());
    parallel_for(dark.size(), [&](std::size_t e) {
        const Element &element = state_.forest.elements[e];
        if (element.leaf() && scene_.reflects(element.surface))
            dark[e] = below_black(scene_, element, state_.radiosity, aim);
    });
    for (std::size_t leaf = 0; leaf < dark.size(); ++leaf)
        if (dark[leaf].depth > allowance_.anywhere())
            fail_darkest(ElementId(leaf), dark[leaf], aim, judgements);
}

/// Its mean over the receiver is below black already: a source's polynomial is, which those of its children are less.
void Oracle::split_sources(const Interaction &interaction, Judgement &judgement) const {
    std::vector<ElementId> sources;
    for (const Link &link : interaction.links) {
        const Element &q = state_.forest[link.source];
        if (q.leaf())
            sources.push_back(link.source);
        for (int c = 0; c < q.n_children; ++c)
            sources.push_back(ElementId(q.first_child.index + c));
    }
    if (sources.size() == interaction.links.size())
        return;
    judgement.sources = std::move(sources);
    if (judgement.verdict == Verdict::keep)
        judgement.verdict = Verdict::relink;
}

void Oracle::fail_darkest(ElementId leaf, const Darkness &dark, double aim,
                          std::vector<std::vector<Judgement>> &judgements) const {
    struct Part {
        double value = 0; ///< that it brings, of the channel where that is least; below 0
        Judgement *judgement = nullptr;
    };
    std::vector<Part> parts;
    double sum = 0;
    const Rgb &rho = scene_.reflectance(state_.forest[leaf].surface);
    for (ElementId node = leaf; node.valid(); node = state_.forest[node].parent)
        for (std::size_t i = 0; i < judgements[node.at()].size(); ++i) {
            const Interaction &interaction = *state_.interactions[node.at()][i];
            const double value = (rho * LinkFit(state_.forest, interaction, state_.radiosity).at(dark.at)).minCoeff();
            Judgement &j = judgements[node.at()][i];
            if (value >= 0 || j.weak)
                continue;
            if (interaction.fit.damping == 0) {
                split_sources(interaction, j);
                continue;
            }
            parts.push_back({value, &j});
            sum += value;
        }
    std::ranges::sort(parts, {}, &Part::value);
    for (const Part &part : parts) {
        if (sum >= -aim)
            return;
        sum -= part.value;
        Judgement &j = *part.judgement;
        j.dark = std::max(j.dark, dark.depth);
        j.damping = std::min(j.damping, dark.damping);
        j.verdict = Verdict::fail;
        j.afresh = false;
    }
}

} // namespace penumbra
