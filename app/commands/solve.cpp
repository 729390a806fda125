#include "commands/command.h"
#include "commands/interrupt.h"
#include "commands/iterate.h"
#include "commands/progress.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "core/parallel.h"
#include "files/probes.h"
#include "files/record.h"
#include "iteration/solver.h"
#include "scene/scene.h"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace penumbra {

namespace {

int run(const SolvingOptions &solving, const CommonOptions &common) {
    check_deliverable(common.output);
    check_deliverable(solving.probe_output);
    const auto scene = std::make_shared<const Scene>(open_scene(solving, common));
    const std::vector<Probe> probes = solving.probe.empty() ? std::vector<Probe>() : read_probes(solving.probe);
    set_threads(solving.options.threads);

    Interrupt interrupt(solving.limits);
    Record record{.scene = solving.scene, .options = solving.options};
    try {
        Solver solver(scene, solving.options, &interrupt.cancel());
        Progress progress(solving.options, common.quiet, common.verbose);
        record.iterations = iterate(solver, solving.options.max_iterations, interrupt.cancel(), progress);
        if (solver.converged())
            interrupt.lift_limits();
        // The error is against an exact solution that takes its time: not after an interrupt.
        record.solution = solver.snapshot(interrupt.exit_status() == done);
        record.health = health(*scene, *solver.state());
    } catch (const Cancelled &) { // while the curves were made: there is no solution yet
    }
    record.stopped_by = interrupt.cause();
    deliver(common.output, to_json(record));
    if (!solving.probe.empty() && record.solution)
        deliver(solving.probe_output, probe_csv(probes, *record.solution, scene->own.size));

    if (const int status = interrupt.exit_status(); status != done) {
        const std::string reached = record.solution
                                        ? fmt::format("the last complete solution, of iteration {}, was written",
                                                      record.solution->counters.iteration)
                                        : "there was no solution yet; the record says so";
        complain(interrupt.sentence() + "; " + reached);
        return status;
    }
    if (record.solution->counters.exhausted) {
        complain(record.solution->sentence);
        return not_reached;
    }
    if (!record.solution->counters.converged) {
        complain("the fixed point was not reached in " + std::to_string(solving.options.max_iterations) +
                 " iterations; raise --max-iterations or --threshold");
        return not_reached;
    }
    return done;
}

} // namespace

Command add_solve(CLI::App &root) {
    CLI::App *parser = root.add_subcommand("solve", "Solves a scene and writes a record of it as JSON");
    const auto solving = std::make_shared<SolvingOptions>();
    const auto common = std::make_shared<CommonOptions>();
    add_scene_options(*parser, *solving);
    add_solving_options(*parser, *solving);
    add_probe_options(*parser, *solving);
    add_common_options(*parser, *common, "The record; standard output unless given");
    return {parser, [=] { return run(*solving, *common); }};
}

} // namespace penumbra
