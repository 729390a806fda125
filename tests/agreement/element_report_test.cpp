// What is told of an element, against what the solver does: what links bring adds up to what was gathered, and the
// verdicts come true in the next refinement.
#include "agreement/every_strategy.h"
#include "iteration/element_report.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "reference/faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <tuple>

namespace penumbra {
namespace {

/// A floor and a wall that light each other, a lamp and a black plate that takes it from a part of both.
std::shared_ptr<const Scene> corner_scene() {
    const Rgb grey(0.5, 0.45, 0.4), none = Rgb::Zero();
    return reference::scene_of({{{{-2, -1.5, 0}, {2, -1.5, 0}, {2, 1.5, 0}, {-2, 1.5, 0}}, grey, none},
                                {{{-2, 1.5, 0}, {2, 1.5, 0}, {2, 1.5, 2}, {-2, 1.5, 2}}, grey, none},
                                {{{-0.5, -0.5, 1.8}, {-0.5, 0.5, 1.8}, {0.5, 0.5, 1.8}, {0.5, -0.5, 1.8}}, none, {3, 2, 1}},
                                {{{-0.2, -0.4, 0.7}, {-0.2, 0.5, 0.7}, {0.9, 0.3, 0.7}, {0.9, -0.4, 0.7}}, none, none}});
}

class ElementReports : public testing::TestWithParam<BasisAndStrategy> {
protected:
    ElementReports() : scene(corner_scene()) {
        options.basis = std::get<0>(GetParam());
        options.strategy = std::get<1>(GetParam());
        options.threshold = is_constant(options.strategy) ? 0.2 : 0.05;
        options.max_depth = 3;
        options.coarse_correction = Switch::off;
    }
    ElementReport ask(const Solver &solver, const State &state, ElementId e) const {
        const Element &element = state.forest[e];
        const Vec3 at = scene->surface(element.surface).frame.to_space(element.basis.centre());
        return *solver.inspect(state, {element.surface.index, scene->own.to_own(at), {}, XrayLine::centre});
    }
    /// Leaves that reflect; a few dozen, where there are many.
    std::vector<ElementId> leaves(const State &state) const {
        std::vector<ElementId> all, out;
        for (std::size_t e = 0; e < state.forest.elements.size(); ++e)
            if (state.forest.elements[e].leaf() && scene->reflects(state.forest.elements[e].surface))
                all.emplace_back(e);
        for (std::size_t k = 0; k < all.size(); k += 1 + all.size() / 30)
            out.push_back(all[k]);
        return out;
    }

    std::shared_ptr<const Scene> scene;
    Options options;
};

TEST_P(ElementReports, WhatLinksBringIsWhatIsGathered) {
    Solver solver(scene, options);
    solver.step();
    solver.step();
    solver.sub_step(); // refine
    solver.sub_step(); // gather, from the radiosity that the state still has
    const auto gathered = solver.state();
    int n_above = 0;
    for (const ElementId e : leaves(*gathered)) {
        const ElementReport r = ask(solver, *gathered, e);
        ASSERT_EQ(r.element, e.index);
        const Vec2 centre = gathered->forest[e].basis.centre();
        Rgb sum = Rgb::Zero(), expected = Rgb::Zero();
        for (const LinkReport &l : r.links) {
            sum += l.at_centre;
            n_above += l.levels_up > 0;
        }
        for (ElementId up = e; up.valid(); up = gathered->forest[up].parent) {
            const Element &element = gathered->forest[up];
            expected += scene->reflectance(element.surface) *
                        (element.basis.evaluate(centre).transpose() * rows(element, gathered->irradiance)).transpose().array();
        }
        EXPECT_LE((sum - expected).abs().maxCoeff(), 1e-12 * gathered->peak) << r.element;
        std::set<int> sources;
        for (const LinkReport &l : r.links)
            EXPECT_TRUE(sources.insert(l.source).second) << "each surface lights it at one level";
    }
    EXPECT_GT(n_above, 0);
}

TEST_P(ElementReports, VerdictsComeTrueInTheNextRefinement) {
    Solver solver(scene, options);
    int n_failed = 0, n_kept = 0, n_at_limit = 0;
    for (int step = 0; step < 9; ++step) {
        solver.step();
        const auto before = solver.state();
        std::vector<std::pair<ElementId, bool>> told;
        for (const ElementId e : leaves(*before)) {
            const ElementReport r = ask(solver, *before, e);
            const bool fails = std::ranges::any_of(r.links, [](const LinkReport &l) {
                return l.verdict == LinkVerdict::splits || l.verdict == LinkVerdict::at_limit;
            });
            n_at_limit += std::ranges::any_of(r.links, [](const auto &l) { return l.verdict == LinkVerdict::at_limit; });
            told.emplace_back(e, fails);
        }
        solver.sub_step();
        const auto after = solver.state();
        for (const auto &[e, fails] : told) {
            const Element &now = after->forest[e];
            EXPECT_EQ(fails, !now.leaf() || now.at_limit) << "step " << step << ", element " << e.index;
            (fails ? n_failed : n_kept)++;
        }
    }
    EXPECT_GT(n_failed, 0);
    EXPECT_GT(n_kept, 0);
    if (is_constant(options.strategy)) {
        EXPECT_GT(n_at_limit, 0);
    }
}

TEST_P(ElementReports, HistoryLeadsFromTheRootToTheElement) {
    Solver solver(scene, options);
    for (int step = 0; step < 3; ++step)
        solver.step();
    const auto state = solver.state();
    for (const ElementId e : leaves(*state)) {
        const ElementReport r = ask(solver, *state, e);
        EXPECT_EQ(r.history.front().born, 0);
        EXPECT_EQ(r.history.back().element, e.index);
        EXPECT_EQ(r.history.back().split, SplitKind::none);
        int cuts = 0;
        double depth = 0;
        for (std::size_t k = 0; k + 1 < r.history.size(); ++k) {
            const ElementStage &stage = r.history[k];
            EXPECT_EQ(state->forest[ElementId(r.history[k + 1].element)].parent.index, stage.element);
            EXPECT_EQ(stage.split_in, r.history[k + 1].born);
            cuts += stage.split == SplitKind::cut;
            depth += stage.split == SplitKind::cut ? 0 : stage.n_children == 4 ? 1 : 0.5;
        }
        EXPECT_EQ(r.n_cuts, cuts);
        EXPECT_EQ(r.depth, depth);
        EXPECT_EQ(history_words(r).size(), r.history.size());
    }
}

INSTANTIATE_TEST_SUITE_P(All, ElementReports, every_basis_and_strategy(), words_for);

} // namespace
} // namespace penumbra
