// basis_table [THRESHOLD]...: the two families of bases side by side, as a table in Markdown; errors against the exact direct
// solution, or a reference from a solution to half the threshold.
#include "solved.h"

#include "iteration/state.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace penumbra;

namespace {

/// Largest |sum of pull push - I| over the elements that have children.
double largest_loss(const Forest &forest) {
    double most = 0;
    for (const Element &e : forest.elements) {
        if (e.leaf())
            continue;
        const int n = e.basis.n_functions();
        Eigen::MatrixXd sum = -Eigen::MatrixXd::Identity(n, n);
        for (int c = 0; c < e.n_children; ++c) {
            const TwoScale &filters = *forest[ElementId(e.first_child.index + c)].filters;
            sum += filters.pull * filters.push;
        }
        most = std::max(most, sum.cwiseAbs().maxCoeff());
    }
    return most;
}

void add_rows(const char *name, double threshold) {
    const auto scene = bundled(name);
    const TrueError error = true_error(scene, 0.5 * threshold);
    for (const BasisFamily basis : {BasisFamily::parametric, BasisFamily::planar}) {
        Options options = options_of(Strategy::discontinuity_wavelet, threshold);
        options.basis = basis;
        Solver solver(scene, options);
        solver.run();
        const Counters &c = solver.counters();
        std::printf("| %s | %g | %s | %.1e | %d | %ld | %ld | %.3f | %.2f %% | %d |\n", name, threshold,
                    std::string(penumbra::name(basis)).c_str(), largest_loss(solver.state()->forest), c.patches,
                    static_cast<long>(c.coefficients), static_cast<long>(c.links), c.seconds, 100 * error(*solver.state()),
                    c.nodes_at_limit);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char **argv) {
    std::vector<double> thresholds;
    for (int i = 1; i < argc; ++i)
        thresholds.push_back(std::atof(argv[i]));
    if (thresholds.empty())
        thresholds = {0.02, 0.005};
    std::printf("| scene | threshold | basis | loss | patches | coefficients | links | seconds | error | at the limit |\n"
                "| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
    for (const char *scene : {"figure-4", "slanted-edge", "skew-blockers", "box-on-floor", "pierced", "stairs", "table",
                              "cornell-box", "next-room"})
        for (const double threshold : thresholds)
            add_rows(scene, threshold);
}
