#include "iteration/state.h"

#include "core/parallel.h"
#include "core/percent.h"
#include "iteration/candidates.h"
#include "iteration/curve_words.h"
#include "iteration/known_curves.h"
#include "iteration/oracle.h"
#include "transport/point_transfer.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace penumbra {

namespace {

/// The least of the detail of a leaf below black that is worth keeping.
constexpr double least_damping = 0.1;

/// A pair that wants links.
struct Request {
    ElementId receiver;
    SurfaceId source;
    Candidates candidates;
    std::vector<ElementId> sources;
    std::shared_ptr<const Interaction> before; ///< of the same pair, to be replaced; none when the pair is new
    Fit fit{};
    LinkReason reason = LinkReason::new_pair;
    std::shared_ptr<const Interaction> replaced{}; ///< see LinkEvent
};

class Refinement {
public:
    Refinement(const Setting &setting, State &state, const Cancel *cancel)
        : setting_(setting), state_(state), scene_(*setting.scene),
          cancel_(cancel),
          transport_(setting.transport(state.counters.threshold, cancel)), oracle_(setting, state) {
        for (int s = 0; s < scene_.n_surfaces(); ++s)
            nothing_emits_ = nothing_emits_ && !scene_.emits(SurfaceId(s));
    }

    void run() {
        judgements_ = oracle_.judge_all();
        split_failing();
        request_new_pairs();
        link();
        count();
    }

private:
    void split_failing() {
        const std::size_t n = judgements_.size();
        std::vector<std::vector<const Interaction *>> failing(n);
        std::vector<std::size_t> to_split;
        for (std::size_t e = 0; e < n; ++e) {
            for (std::size_t i = 0; i < judgements_[e].size(); ++i)
                if (judgements_[e][i].verdict == Verdict::fail)
                    failing[e].push_back(state_.interactions[e][i].get());
            Element &element = state_.forest.elements[e];
            if (!failing[e].empty() && element.leaf())
                to_split.push_back(e);
            else
                element.at_limit = false;
        }
        trace_failing(failing);
        std::vector<std::optional<Split>> splits(to_split.size());
        std::vector<Work> work(to_split.size());
        parallel_for(to_split.size(), [&](std::size_t i) {
            const ElementId node(to_split[i]);
            splits[i] = best_split(setting_, transport_, state_, node, failing[node.at()],
                                   oracle_.allowance().misfit(state_.forest[node]), work[i]);
        });
        for (const Work &w : work)
            state_.counters.work += w;
        for (std::size_t i = 0; i < to_split.size(); ++i)
            apply(ElementId(to_split[i]), splits[i]);
        for (SplitEvent &event : events_.splits)
            for (std::size_t i = 0; i < judgements_[event.element.at()].size(); ++i)
                if (judgements_[event.element.at()][i].verdict == Verdict::fail)
                    event.handed_down.push_back(state_.interactions[event.element.at()][i]);
        inherit_radiosity();
        for (std::size_t e = 0; e < n; ++e)
            hand_down(ElementId(e));
    }

    /// A reflector whose light a leaf fails to fit brings more than the oracle lets pass: its curves are worth it.
    void trace_failing(const std::vector<std::vector<const Interaction *>> &failing) {
        if (!cuts_along_curves(setting_.options.strategy) || is(Effect::curves_secondary, Switch::off))
            return;
        std::vector<LightPath> paths;
        for (std::size_t e = 0; e < failing.size(); ++e)
            for (const Interaction *interaction : failing[e])
                if (state_.forest.elements[e].leaf() && interaction->kind == PairKind::partly_hidden)
                    paths.push_back({state_.forest.elements[e].surface, interaction->source});
        trace_paths(setting_, state_, std::move(paths), cancel_);
    }

    void apply(ElementId node, const std::optional<Split> &split) {
        Forest &forest = state_.forest;
        forest[node].at_limit = !split;
        if (!split)
            return;
        if (split->cut)
            cut(forest, node, *split->cut, state_.counters.iteration);
        else
            subdivide(forest, node, state_.counters.iteration);
        ++state_.counters.splits;
        state_.counters.cuts += split->cut.has_value();
        tell(node, *split);
    }

    void tell(ElementId node, const Split &split) {
        const Element &e = state_.forest[node];
        double worst = 0, dark = 0;
        SurfaceId source;
        for (std::size_t i = 0; i < judgements_[node.at()].size(); ++i)
            if (dark = std::max(dark, judgements_[node.at()][i].dark); judgements_[node.at()][i].misfit > worst) {
                worst = judgements_[node.at()][i].misfit;
                source = state_.interactions[node.at()][i]->source;
            }
        std::string how = split.cut ? "cut in a straight line" : e.n_children == 2 ? "split in two" : "split in four";
        if (split.curve) {
            const SnapshotCurve &curve = (*state_.drawn_curves)[split.curve->at()];
            how = "cut along the " + curve_words(curve, [&](int s) { return scene_.words_for(SurfaceId(s)); });
        }
        const double threshold = state_.counters.threshold;
        const std::string sentence =
            scene_.words_for(e.surface) + ", element " + std::to_string(node.index) + ": order " + std::to_string(e.basis.order()) +
            (worst > 1 ? " misses what " + scene_.words_for(source) + " brings by " + percent(worst * threshold)
                       : " falls below black by " + percent(dark / oracle_.allowance().anywhere() * threshold)) +
            " of the peak > " + percent(threshold) + "; " + how;
        if (!told_ || (split.cut && !told_cut_)) {
            told_ = sentence;
            told_cut_ = split.cut.has_value();
        }
        events_.splits.push_back(
            {node, split.cut.has_value(), split.curve, source, worst * threshold, threshold, {}, sentence});
    }

    /// New elements start with what their parent had, so that the change of an iteration is not their making.
    void inherit_radiosity() {
        const Forest &forest = state_.forest;
        const Eigen::Index before = state_.radiosity.rows();
        state_.radiosity.conservativeResize(forest.n_coefficients, 3);
        state_.irradiance.conservativeResize(forest.n_coefficients, 3);
        for (const Element &e : forest.elements)
            if (e.first >= before) {
                const Element &parent = forest[e.parent];
                state_.radiosity.middleRows(e.first, e.basis.n_functions()) =
                    e.filters->push * state_.radiosity.middleRows(parent.first, parent.basis.n_functions());
                state_.irradiance.middleRows(e.first, e.basis.n_functions()).setZero();
            }
        state_.interactions.resize(forest.elements.size());
    }

    /// Failing interactions go to the children; those to be linked anew are asked for at the same node. Where a limit
    /// keeps a node that fails, its fit shall at least be the best there is: it is integrated anew, finer;
    /// and damped where it brings the node below black.
    void hand_down(ElementId node) {
        auto &here = state_.interactions[node.at()];
        std::vector<std::shared_ptr<const Interaction>> kept;
        for (std::size_t i = 0; i < here.size(); ++i) {
            const Judgement &j = judgements_[node.at()][i];
            const bool at_limit = j.verdict == Verdict::fail && state_.forest[node].leaf();
            const bool same_sources = j.sources.size() == here[i]->links.size();
            Fit fit = here[i]->fit;
            fit.fine |= at_limit;
            if (at_limit && j.dark > 0)
                fit.damping = fit.damping * j.damping > least_damping ? fit.damping * j.damping : 0;
            if (j.verdict == Verdict::keep || (at_limit && same_sources && here[i]->fit == fit))
                kept.push_back(here[i]);
            else if (j.verdict == Verdict::fail && !at_limit) {
                auto replaced = was_split(node) ? nullptr : here[i];
                descend(node, *here[i], j, replaced);
            } else
                requests_.push_back({node, here[i]->source, here[i]->candidates(), j.sources, j.afresh ? nullptr : here[i], fit,
                                     at_limit           ? LinkReason::limit
                                     : j.afresh         ? LinkReason::order_too_low
                                     : here[i]->weak    ? LinkReason::too_bright
                                                        : LinkReason::source_too_coarse,
                                     here[i]});
        }
        here = std::move(kept);
    }

    /// In this refinement.
    bool was_split(ElementId node) const {
        const Element &e = state_.forest[node];
        return !e.leaf() && state_.forest[e.first_child].born == state_.counters.iteration;
    }

    /// The first of the parts takes what is replaced.
    void descend(ElementId node, const Interaction &interaction, const Judgement &judgement,
                 std::shared_ptr<const Interaction> &replaced) {
        const Element &e = state_.forest[node];
        for (int c = 0; c < e.n_children; ++c) {
            const ElementId child(e.first_child.index + c);
            // The first piece of a cut in two steps is cut already.
            if (!state_.forest[child].leaf() && state_.forest[child].born == state_.counters.iteration)
                descend(child, interaction, judgement, replaced);
            else
                requests_.push_back({child, interaction.source, interaction.candidates(), judgement.sources, nullptr, {},
                                     LinkReason::handed_down, std::exchange(replaced, nullptr)});
        }
    }

    bool is(Effect effect, Switch value) const { return setting_.options.effects[effect] == value; }

    void request_new_pairs() {
        for (std::size_t r = 0; r < scene_.surfaces.size(); ++r)
            for (std::size_t s = 0; s < scene_.surfaces.size(); ++s)
                if (r != s && !state_.linked[r][s] && scene_.reflects(SurfaceId(r)) && may_shine(SurfaceId(s))) {
                    state_.linked[r][s] = 1;
                    request_pair(SurfaceId(r), SurfaceId(s));
                }
    }

    bool may_shine(SurfaceId s) const {
        return setting_.plan.emission && (oracle_.brightness(s).maxCoeff() > 0 || nothing_emits_);
    }

    void request_pair(SurfaceId receiver, SurfaceId source) {
        const auto &roots = state_.forest.roots[receiver.at()], &sources = state_.forest.roots[source.at()];
        const auto n_roots = static_cast<std::int64_t>(roots.size());
        Work &work = state_.counters.work;
        if (!setting_.plan.is_lit(receiver)) {
            work.spared[Effect::two_sided] += n_roots;
            return;
        }
        if (!setting_.plan.interreflection && !scene_.emits(source)) {
            work.spared[Effect::interreflection] += n_roots;
            return;
        }
        work.pairs += n_roots;
        std::optional<Candidates> candidates;
        for (const ElementId root : roots) {
            if (form_factor_bound(transport_, state_.forest[root], source) <= 0)
                continue;
            if (!candidates && setting_.hidden_pairs && setting_.hidden_pairs->hidden(source, receiver)) {
                work.spared[Effect::hidden_pairs] += n_roots * static_cast<std::int64_t>(sources.size());
                return;
            }
            if (!candidates)
                candidates = all_candidates(transport_, receiver, source);
            requests_.push_back({root, source, *candidates, sources, nullptr});
        }
    }

    void link() {
        std::vector<std::shared_ptr<const Interaction>> made(requests_.size());
        std::vector<Work> work(requests_.size());
        parallel_for(requests_.size(), [&](std::size_t i) {
            const Request &r = requests_[i];
            made[i] = connect(transport_, state_.forest, r.receiver, r.source, r.candidates, r.sources,
                              oracle_.leeway(r.receiver, r.source), work[i], r.before.get(), r.fit);
        });
        for (std::size_t i = 0; i < made.size(); ++i) {
            state_.counters.work += work[i];
            if (!made[i]->links.empty())
                state_.interactions[requests_[i].receiver.at()].push_back(made[i]);
            if (!made[i]->links.empty() || requests_[i].replaced)
                events_.links.push_back({requests_[i].reason, std::move(made[i]), std::move(requests_[i].replaced)});
        }
    }

    void count() {
        Counters &c = state_.counters;
        c.patches = c.nodes_at_limit = 0;
        c.curves = static_cast<int>(state_.curves->curves().size());
        c.untraced_pairs = state_.n_untraced;
        c.coefficients = c.links = c.lower_links = 0;
        for (std::size_t e = 0; e < state_.forest.elements.size(); ++e) {
            const Element &element = state_.forest.elements[e];
            for (const auto &interaction : state_.interactions[e])
                for (const Link &link : interaction->links) {
                    ++c.links;
                    c.lower_links += interaction->order < element.basis.order() || link.left_out.size() > 0;
                    c.link_coefficients += link.kernel.size();
                    c.spared_link_coefficients += element.basis.n_functions() * n_columns(scene_, state_.forest[link.source]) - link.kernel.size();
                }
            if (!element.leaf() || !scene_.reflects(element.surface))
                continue;
            ++c.patches;
            c.coefficients += element.basis.n_functions();
            c.nodes_at_limit += element.at_limit;
        }
        changed_ = !requests_.empty();
        state_.sentence = told_ ? *told_ : changed_ ? "linked " + std::to_string(requests_.size()) + " pairs"
                                                    : "every interaction passed the oracle: nothing to refine";
        if (told_ && c.splits > 1)
            state_.sentence += " (and " + std::to_string(c.splits - 1) + " more)";
        c.refined = changed_;
        state_.events = std::make_shared<const RefineEvents>(std::move(events_));
    }

    const Setting &setting_;
    State &state_;
    const Scene &scene_;
    const Cancel *cancel_;
    Transport transport_;
    Oracle oracle_;
    std::vector<std::vector<Judgement>> judgements_; ///< as state.interactions
    std::vector<Request> requests_;
    RefineEvents events_;
    std::optional<std::string> told_;
    bool told_cut_ = false, changed_ = false;
    bool nothing_emits_ = true;
};

} // namespace

void refine(const Setting &setting, State &state, const Cancel *cancel) { Refinement(setting, state, cancel).run(); }

} // namespace penumbra
