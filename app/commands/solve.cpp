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
#include "iteration/state.h"
#include "measure/error_estimate.h"
#include "scene/scene.h"
#include "study/price.h"
#include "study/run_watch.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

namespace penumbra {

namespace {

/// Measures the solution. Where a limit stopped it on the way to a tolerance, a solution of an earlier iteration may be the
/// better one (`best`), and then takes its place; what was stopped in the middle of refining is given a while to be
/// measured, no longer. With a threshold there is nothing to choose from, and the limit holds.
void measure(Solver &solver, const std::shared_ptr<const State> &best, const Interrupt &interrupt) {
    const bool stopped = interrupt.exit_status() != done;
    if (interrupt.cause() == "interrupt" || (stopped && !solver.options().tolerance))
        return;
    constexpr double a_while = 2; // [s]
    const Cancel never;
    const RunWatch watch({stopped ? a_while : std::optional<double>(), std::nullopt}, stopped ? never : interrupt.cancel());
    try {
        solver.measure(&watch.cancel());
    } catch (const Cancelled &) {
    }
    const double error = solver.counters().estimated_error;
    if (best && (error < 0 || best->counters.estimated_error < error))
        solver.restore(best);
}

std::string accuracy(const Counters &counters) {
    return counters.estimated_error >= 0 ? "; its error is about " + error_in_words(counters) : "";
}

/// Seconds to the tolerance as they could be told when the error was first measured; nothing where that was the end.
std::optional<double> predicted_seconds(const Scene &scene, const Options &options, const std::vector<Counters> &iterations) {
    if (!(options.tolerance.value_or(0) > 0))
        return std::nullopt;
    for (const Counters &c : iterations) {
        const auto paid = price_paid(options, c);
        if (!paid)
            continue;
        if (c.converged)
            break;
        return predict_price({&*paid, 1}, usual_growth(options, has_one_bounce(scene)), *options.tolerance)->seconds;
    }
    return std::nullopt;
}

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
        std::shared_ptr<const State> best;
        record.iterations = iterate(solver, solving.options.max_iterations, interrupt.cancel(), progress, &best);
        record.predicted_seconds = predicted_seconds(*scene, solving.options, record.iterations);
        if (solver.converged())
            interrupt.lift_limits();
        measure(solver, best, interrupt);
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
                                        ? fmt::format("the {} complete solution, of iteration {}, was written{}",
                                                      solving.options.tolerance ? "most accurate" : "last",
                                                      record.solution->counters.iteration, accuracy(record.solution->counters))
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

constexpr double usual_tolerance = 0.01;

/// Where neither a threshold nor a tolerance is given.
void ask_by_default(const CLI::App &parser, SolvingOptions &solving) {
    if (parser.count("--threshold") > 0 || parser.count("--tolerance") > 0)
        return;
    const int depth = solving.options.max_depth;
    solving.options = solving.options.to_tolerance(solving.limits.seconds ? 0 : usual_tolerance);
    if (parser.count("--max-depth") > 0)
        solving.options.max_depth = depth;
}

} // namespace

Command add_solve(CLI::App &root) {
    CLI::App *parser = root.add_subcommand("solve", "Solves a scene and writes a record of it as JSON");
    const auto solving = std::make_shared<SolvingOptions>();
    const auto common = std::make_shared<CommonOptions>();
    add_scene_options(*parser, *solving);
    add_solving_options(*parser, *solving);
    add_probe_options(*parser, *solving);
    parser->footer("With neither --tolerance nor --threshold the tolerance is 0.01; with --time-limit alone, what comes out is as "
                   "accurate\nas can be had in that time.");
    add_common_options(*parser, *common, "The record; standard output unless given");
    return {parser, [=] {
                ask_by_default(*parser, *solving);
                return run(*solving, *common);
            }};
}

} // namespace penumbra
