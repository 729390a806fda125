// delivered_table [--limit SECONDS] [--scenes A,B] [--tolerances X,Y]: is the accuracy delivered that was asked for? Each
// bundled scene to each tolerance by the default strategy; what the solver estimated beside what a reference says. Stops
// going tighter in a scene once a run takes longer than the limit. A table in Markdown; exit status 1 when an error
// exceeds its tolerance.
#include "solved.h"

#include "core/machine.h"
#include "core/parallel.h"
#include "iteration/state.h"
#include "study/run_watch.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

using namespace penumbra;

namespace {

struct Verdicts {
    int runs = 0, delivered = 0, frugal = 0, truthful = 0;
};

void add_rows(const std::string &name, const std::vector<double> &tolerances, double limit, Verdicts &verdicts) {
    const auto scene = bundled(name.c_str());
    const bool one_bounce = has_one_bounce(*scene);
    const Cancel never;
    std::vector<std::shared_ptr<const State>> solved;
    std::vector<double> asked;
    for (const double tolerance : tolerances) {
        if (tolerance < 0.003 && !one_bounce)
            continue;
        const RunWatch watch({limit, std::nullopt}, never);
        try {
            Solver solver(scene, Options().to_tolerance(tolerance));
            solver.run(&watch.cancel());
            solved.push_back(solver.state());
            asked.push_back(tolerance);
        } catch (const Cancelled &) {
            std::printf("| %s | %g | > %g | | | | | |\n", name.c_str(), tolerance, limit);
            break;
        }
    }
    if (solved.empty())
        return;
    std::shared_ptr<const Reference> reference;
    if (!one_bounce) {
        // Tighter than all of them where that can be had in four times the limit; else gathered from the finest of them.
        ConvergedSolution best{std::make_shared<const Forest>(solved.back()->forest), solved.back()->radiosity,
                               solved.back()->counters.error_limit};
        const RunWatch watch({4 * limit, std::nullopt}, never);
        try {
            best = solve_for_reference(scene, 0.5 * asked.back(), &watch.cancel());
        } catch (const Cancelled &) {
        }
        reference = std::make_shared<const Reference>(scene, std::move(best));
    }
    const TrueError error = error_against(scene, reference);
    for (std::size_t i = 0; i < solved.size(); ++i) {
        const Counters &c = solved[i]->counters;
        const double measured = reference ? error_against(*reference, *scene, {solved[i]->forest, solved[i]->radiosity}, 16384)
                                          : error(*solved[i]);
        ++verdicts.runs;
        verdicts.delivered += measured <= asked[i];
        verdicts.frugal += measured > 0.1 * asked[i];
        verdicts.truthful += c.estimated_error < 2 * measured && measured < 2 * c.estimated_error;
        std::printf("| %s | %g | %.2f | %d | %.3g | %.3g | %.2f | %.2f | %s%.1g |\n", name.c_str(), asked[i], c.seconds,
                    c.patches, c.estimated_error, measured, measured / asked[i],
                    measured > 0 ? c.estimated_error / measured : 0.0, c.converged ? "" : "not converged, ",
                    reference ? reference->error() : 0.0);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char **argv) {
    double limit = 600;
    std::vector<std::string> scenes;
    for (const BundledScene &s : bundled_scenes())
        scenes.emplace_back(s.name);
    std::vector<double> tolerances{0.1, 0.03, 0.01, 0.003, 0.001};
    CLI::App options("Errors delivered beside tolerances asked for");
    options.add_option("--limit", limit, "Seconds of a run");
    options.add_option("--scenes", scenes)->delimiter(',');
    options.add_option("--tolerances", tolerances, "From the loosest")->delimiter(',');
    CLI11_PARSE(options, argc, argv);
    std::printf("%s, %d threads\n\n| scene | tolerance | seconds | patches | estimated | measured | measured / tolerance | "
                "estimated / measured | reference's own |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n",
                cpu_model().c_str(), threads());
    Verdicts verdicts;
    for (const std::string &scene : scenes)
        add_rows(scene, tolerances, limit, verdicts);
    std::printf("\n%d runs: %d delivered, %d of them above a tenth of the tolerance, %d estimates within a factor of two\n",
                verdicts.runs, verdicts.delivered, verdicts.frugal, verdicts.truthful);
    return verdicts.delivered == verdicts.runs ? 0 : 1;
}
