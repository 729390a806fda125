// cutting_table [THRESHOLD]: what cutting does on several scenes, as a table in Markdown; errors
// against the exact direct solution, or a reference from a solution to half the threshold.
#include "solved.h"

#include "iteration/state.h"

#include <cstdio>
#include <cstdlib>
#include <string>

using namespace penumbra;

namespace {

struct Way {
    const char *title;
    Strategy strategy;
    CutChoice cut;
    bool reflector_curves;
};

constexpr Way ways[] = {{"uniform", Strategy::uniform_wavelet, CutChoice::curves, false},
                        {"emitters' curves", Strategy::discontinuity_wavelet, CutChoice::curves, false},
                        {"curves", Strategy::discontinuity_wavelet, CutChoice::curves, true},
                        {"best", Strategy::discontinuity_wavelet, CutChoice::best, true}};

void add_rows(const char *name, double threshold) {
    const auto scene = bundled(name);
    const TrueError error = true_error(scene, 0.5 * threshold);
    const bool one_bounce = has_one_bounce(*scene);
    for (const Way &way : ways) {
        if (one_bounce && way.strategy == Strategy::discontinuity_wavelet && !way.reflector_curves)
            continue; // nothing that reflects lights anything
        Options options = options_of(way.strategy, threshold);
        options.cut = way.cut;
        options.effects[Effect::curves_secondary] = way.reflector_curves ? Switch::automatic : Switch::off;
        Solver solver(scene, options);
        solver.run();
        const Counters &c = solver.counters();
        std::printf("| %s | %s | %d | %.2f %% | %.3f | %ld | %d | %d |\n", name, way.title, c.patches, 100 * error(*solver.state()),
                    c.seconds, static_cast<long>(c.total_work.kernel_evaluations), c.nodes_at_limit, c.curves);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char **argv) {
    const double threshold = argc > 1 ? std::atof(argv[1]) : 0.01;
    std::printf(
        "| scene, threshold %g | cuts | patches | error | seconds | kernel evaluations | at the limit | curves |\n"
        "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n",
        threshold);
    for (const char *scene :
         {"figure-4", "slanted-edge", "skew-blockers", "box-on-floor", "stairs", "cornell-box", "next-room"})
        add_rows(scene, threshold);
}
