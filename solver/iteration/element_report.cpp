#include "iteration/element_report.h"

#include "core/percent.h"
#include "iteration/link_fit.h"
#include "iteration/oracle.h"
#include "iteration/take_snapshot.h"
#include "measure/leaf_at.h"

#include <algorithm>
#include <cstdio>
#include <functional>

namespace penumbra {

namespace {

std::string watts(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", x);
    return text;
}

class Inspection {
public:
    Inspection(const Setting &setting, const State &state, const Cancel *cancel)
        : setting_(setting), state_(state), scene_(*setting.scene), cancel_(cancel), oracle_(setting, state),
          judgements_(oracle_.judge_all()) {}

    ElementReport report(const ElementQuestion &question) {
        const SurfaceId surface(question.surface);
        const PlaneFrame &frame = scene_.surface(surface).frame;
        picked_ = leaf_at(state_.forest, surface, frame.to_plane(scene_.own.to_solver(question.point)));
        const Element &leaf = state_.forest[picked_];
        ElementReport out;
        out.question = question;
        out.element = picked_.index;
        out.surface = surface.index;
        out.surface_name = scene_.words_for(surface);
        out.basis = leaf.basis.planar() ? BasisFamily::planar : BasisFamily::parametric;
        out.order = leaf.basis.order();
        out.n_cuts = leaf.n_cuts;
        out.depth = leaf.depth();
        out.area = leaf.basis.area() * scene_.own.size * scene_.own.size;
        out.at_limit = leaf.at_limit;
        out.outline = outline_of(leaf);
        out.coefficients = rows(leaf, state_.radiosity);
        out.peak = state_.peak;
        out.threshold = state_.counters.threshold;
        out.mean_square = oracle_.allowance().mean_square();
        add_history(out);
        for (ElementId e = picked_; e.valid(); e = state_.forest[e].parent)
            for (std::size_t i = 0; i < state_.interactions[e.at()].size(); ++i) {
                const Interaction &interaction = *state_.interactions[e.at()][i];
                if (question.source == interaction.source.index)
                    out.xray = xray(setting_, state_, oracle_, picked_, interaction, question.line, cancel_);
                out.links.push_back(link_report(interaction, judgements_[e.at()][i]));
            }
        std::ranges::stable_sort(out.links, std::greater(), [](const LinkReport &l) { return l.mean.maxCoeff(); });
        return out;
    }

private:
    Vec3 centre_of(ElementId e) const {
        const Element &element = state_.forest[e];
        return scene_.own.to_own(scene_.surface(element.surface).frame.to_space(element.basis.centre()));
    }
    std::vector<Vec3> outline_of(const Element &e) const {
        std::vector<Vec3> out;
        for (const Vec2 &corner : e.basis.outline())
            out.push_back(scene_.own.to_own(scene_.surface(e.surface).frame.to_space(corner)));
        return out;
    }

    void add_history(ElementReport &out) const {
        for (ElementId e = picked_; e.valid(); e = state_.forest[e].parent) {
            const Element &element = state_.forest[e];
            const int split_in = element.leaf() ? 0 : state_.forest[element.first_child].born;
            out.history.push_back({e.index, element.depth(), element.born, element.split, element.n_children, split_in});
        }
        std::ranges::reverse(out.history);
    }

    int levels_up(ElementId receiver) const {
        int n = 0;
        for (ElementId e = picked_; e != receiver; e = state_.forest[e].parent)
            ++n;
        return n;
    }

    LinkReport link_report(const Interaction &interaction, const Judgement &judgement) const {
        const Element &receiver = state_.forest[interaction.receiver], &leaf = state_.forest[picked_];
        const Rgb rho = scene_.reflectance(receiver.surface);
        LinkReport out;
        out.receiver = interaction.receiver.index;
        out.levels_up = levels_up(interaction.receiver);
        out.source = interaction.source.index;
        out.kind = link_kind(interaction.kind);
        out.n_links = static_cast<int>(interaction.links.size());
        out.order = interaction.order;
        out.full_order = receiver.basis.order();
        out.weak = interaction.weak;
        const LinkFit fit(state_.forest, interaction, state_.radiosity);
        out.at_centre = rho * fit.at(leaf.basis.centre());
        out.mean = Rgb::Zero();
        double area = 0;
        for (const QuadraturePoint &q : leaf.basis.quadrature(leaf.basis.order() + 1)) {
            out.mean += q.area * rho * fit.at(q.position);
            area += q.area;
        }
        out.mean /= area;
        judge(interaction, judgement, out);
        out.centre = centre_of(interaction.receiver);
        out.outline = outline_of(receiver);
        for (const Link &link : interaction.links)
            out.sources.push_back(centre_of(link.source));
        return out;
    }

    void judge(const Interaction &interaction, const Judgement &judgement, LinkReport &out) const {
        const Element &receiver = state_.forest[interaction.receiver];
        out.passes = oracle_.allowance().misfit(receiver);
        out.misfit = oracle_.allowance().measured(interaction, state_, scene_.reflectance(receiver.surface));
        out.share = judgement.misfit;
        out.dark = judgement.dark;
        out.at_most = oracle_.most_brought(interaction);
        out.weak_below = oracle_.weak_below();
        switch (judgement.verdict) {
        case Verdict::keep:
            out.verdict = judgement.weak ? LinkVerdict::weak : LinkVerdict::passes;
            break;
        case Verdict::relink:
            out.verdict = judgement.afresh      ? LinkVerdict::order_too_low
                          : interaction.weak    ? LinkVerdict::too_bright_for_weak
                                                : LinkVerdict::source_too_coarse;
            break;
        case Verdict::fail:
            out.verdict = !receiver.leaf()     ? LinkVerdict::descends
                          : receiver.at_limit  ? LinkVerdict::at_limit
                                               : LinkVerdict::splits;
            break;
        }
        out.words = words(out);
    }

    /// "it misses 3 % of the peak > 2 %", or what else it fails for.
    std::string reason(const LinkReport &link) const {
        if (link.share > 1)
            return "it misses " + against_limit(link);
        const double threshold = state_.counters.threshold;
        return "it misses most of those that bring the element " + percent(link.dark / oracle_.allowance().anywhere() * threshold) +
               " of the peak below black > " + percent(threshold);
    }

    /// "0.4 % of the peak < 2 %"
    std::string against_limit(const LinkReport &link) const {
        const bool passes = link.share <= 1;
        if (oracle_.allowance().mean_square())
            return watts(link.misfit) + (passes ? " < " : " > ") + watts(link.passes) + " W/m\u00b2 (rms)";
        const double threshold = state_.counters.threshold;
        return percent(link.share * threshold) + " of the peak " + (passes ? "< " : "> ") + percent(threshold);
    }

    std::string words(const LinkReport &link) const {
        switch (link.verdict) {
        case LinkVerdict::passes:
            return "passes: misses " + against_limit(link);
        case LinkVerdict::weak:
            return "weak: brings or varies by at most " + watts(link.at_most) + " < " + watts(link.weak_below) +
                   " W/m\u00b2, too little to be tested";
        case LinkVerdict::order_too_low:
            return "linked anew next: order " + std::to_string(link.order) + " has become too low for what it brings";
        case LinkVerdict::source_too_coarse:
            return "linked anew next: from finer parts of the source, whose detail has come to matter";
        case LinkVerdict::too_bright_for_weak:
            return "linked anew next: it has become too bright for a constant";
        case LinkVerdict::splits:
            return "fails: " + reason(link) + "; the element is split next";
        case LinkVerdict::descends:
            return "fails: " + reason(link) + "; the parts are linked next";
        case LinkVerdict::at_limit:
            return "kept at the depth limit though " + reason(link);
        }
        return {};
    }

    const Setting &setting_;
    const State &state_;
    const Scene &scene_;
    const Cancel *cancel_;
    Oracle oracle_;
    std::vector<std::vector<Judgement>> judgements_;
    ElementId picked_;
};

} // namespace

ElementReport element_report(const Setting &setting, const State &state, const ElementQuestion &question,
                             const Cancel *cancel) {
    return Inspection(setting, state, cancel).report(question);
}

std::string heading(const ElementReport &r) {
    const std::string cuts = r.n_cuts == 0   ? ""
                             : r.n_cuts == 1 ? "cut once, "
                             : r.n_cuts == 2 ? "cut twice, "
                                             : "cut " + std::to_string(r.n_cuts) + " times, ";
    char depth[16];
    std::snprintf(depth, sizeof depth, "%g", r.depth);
    return r.surface_name + ", element " + std::to_string(r.element) + ": order " + std::to_string(r.order) + ", " + cuts +
           "depth " + depth;
}

std::vector<std::string> history_words(const ElementReport &report) {
    std::vector<std::string> out;
    for (const ElementStage &stage : report.history) {
        const std::string element = "element " + std::to_string(stage.element);
        if (stage.split == SplitKind::none)
            out.push_back(stage.born == 0 ? "It has been whole since the start."
                                          : "It has been whole since iteration " + std::to_string(stage.born) + ".");
        else
            out.push_back("Iteration " + std::to_string(stage.split_in) + ": " + element +
                          (stage.split == SplitKind::cut ? " was cut in two."
                           : stage.n_children == 4       ? " was split in four."
                                                         : " was halved."));
    }
    return out;
}

} // namespace penumbra
