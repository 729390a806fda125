// Links laid out for the gather bring what the links themselves do.
#include "iteration/link_batch.h"

#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"

#include <gtest/gtest.h>

namespace penumbra {
namespace {

struct Case {
    Strategy strategy;
    BasisFamily basis;
    int order;
};

class LinkBatchTest : public testing::TestWithParam<Case> {
protected:
    static std::shared_ptr<const State> solved() {
        Options options;
        options.strategy = GetParam().strategy;
        options.basis = GetParam().basis;
        options.order = GetParam().order;
        options.threshold = 0.05;
        Solver solver(std::make_shared<const Scene>(open_scene("cornell-box")), options);
        for (int i = 0; i < 4; ++i)
            solver.step();
        return solver.state();
    }
};

TEST_P(LinkBatchTest, BringsWhatItsLinksDo) {
    const auto state = solved();
    const Forest &forest = state->forest;
    double largest = 0;
    std::size_t n_links = 0;
    for (std::size_t e = 0; e < forest.elements.size(); ++e) {
        const Element &p = forest.elements[e];
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(p.basis.n_functions(), 3);
        std::size_t n_here = 0;
        for (const auto &interaction : state->interactions[e])
            for (const Link &link : interaction->links) {
                const Eigen::MatrixXd b = state->radiosity.middleRows(forest[link.source].first, link.kernel.cols());
                for (int k = 0; k < link.kernel.rows(); ++k)
                    sum.row(p.basis.place(interaction->order, k)) += link.kernel.row(k) * b;
                ++n_here;
            }
        ASSERT_EQ(state->batches[e] != nullptr, n_here > 0);
        if (n_here == 0)
            continue;
        EXPECT_EQ(state->batches[e]->n_links(), n_here);
        n_links += n_here;
        Coefficients irradiance = Coefficients::Zero(p.basis.n_functions(), 3);
        state->batches[e]->add_irradiance(state->radiosity, irradiance);
        largest = std::max(largest, sum.cwiseAbs().maxCoeff());
        EXPECT_LE((irradiance - sum).cwiseAbs().maxCoeff(), 1e-13 * largest) << "element " << e;
    }
    EXPECT_EQ(n_links, static_cast<std::size_t>(state->counters.links));
    EXPECT_GT(largest, 0);
}

// A kernel is there twice, in the interaction and in the batch; what comes on top is counted by the link.
TEST_P(LinkBatchTest, MemoryIsCounted) {
    const auto state = solved();
    std::size_t n_values = 0;
    for (const auto &here : state->interactions)
        for (const auto &interaction : here)
            for (const Link &link : interaction->links)
                n_values += 2 * static_cast<std::size_t>(link.kernel.size()) + static_cast<std::size_t>(link.misfit.size());
    const auto values = static_cast<std::int64_t>(n_values * sizeof(double));
    EXPECT_GT(state->counters.link_bytes, values);
    EXPECT_LT(state->counters.link_bytes, values + 100 * state->counters.links);
}

INSTANTIATE_TEST_SUITE_P(Bases, LinkBatchTest,
                         testing::Values(Case{Strategy::uniform_constant, BasisFamily::parametric, 1},
                                         Case{Strategy::uniform_wavelet, BasisFamily::parametric, 2},
                                         Case{Strategy::uniform_wavelet, BasisFamily::planar, 2},
                                         Case{Strategy::discontinuity_wavelet, BasisFamily::parametric, 3},
                                         Case{Strategy::discontinuity_wavelet, BasisFamily::planar, 3},
                                         Case{Strategy::discontinuity_wavelet, BasisFamily::parametric, 4},
                                         Case{Strategy::discontinuity_wavelet, BasisFamily::planar, 4}));

} // namespace
} // namespace penumbra
