#include "capture.h"
#include "commands/command.h"
#include "commands/interrupt.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "core/machine.h"
#include "core/parallel.h"
#include "core/percent.h"
#include "files/cost_table.h"
#include "files/find_reference.h"
#include "files/saved_state.h"
#include "files/write_state.h"
#include "plot/cost_sheet.h"
#include "plot/plot_picture.h"
#include "plot/svg_canvas.h"
#include "window/offscreen.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace penumbra {

namespace {

constexpr int sheet_width = 2000, sheet_height = 860; ///< pixels
constexpr float sheet_text = 20;

struct CostOptions {
    SolvingOptions solving;
    CommonOptions common;
    CostRange range;
    double reference = picture_tolerance;
};

/// Null where cancelled. On a terminal says how far it is.
std::shared_ptr<const Reference> reference_for(const std::shared_ptr<const Scene> &scene, const CostOptions &options,
                                               const Cancel &cancel) {
    const CommonOptions &common = options.common;
    const bool line = !common.quiet && !common.verbose && error_is_terminal();
    const auto show = [&](const Counters &c) {
        const std::string so_far = c.estimated_error >= 0 ? ", error about " + percent(c.estimated_error) : "";
        if (line || common.verbose)
            std::fprintf(stderr, "%sreference to %s: iteration %d%s%s", line ? "\r\033[K" : "",
                         percent(options.reference).c_str(), c.iteration, so_far.c_str(), line ? "" : "\n");
        std::fflush(stderr);
    };
    std::shared_ptr<const Reference> reference;
    try {
        reference = find_reference(scene, options.reference, &cancel, show);
    } catch (const Cancelled &) {
    }
    if (line)
        std::fputs("\r\033[K", stderr);
    return reference;
}

void make_folder(const std::filesystem::path &folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Unavailable("cannot make the folder " + folder.string() + ": " + error.message());
}

std::string in_words(const CostPoint &p) {
    return std::string(name(p.options.strategy)) + ", " + std::string(name(p.options.basis));
}

/// A bar on a terminal; with -v a line for each run anywhere.
void show(const CommonOptions &common, const CostPoint &p, int done, int all) {
    if (common.quiet)
        return;
    if (common.verbose) {
        std::fprintf(stderr, "%d of %d: %s, threshold %g: %s, %.3g s, %d patches", done, all, in_words(p).c_str(),
                     p.options.threshold, std::string(name(p.end)).c_str(), p.seconds.back(), p.counters.patches);
        std::fprintf(stderr, p.error >= 0 ? ", error %.3g %%\n" : "\n", 100 * p.error);
    } else if (error_is_terminal()) {
        constexpr int width = 30;
        std::string bar(width, '.');
        std::fill_n(bar.begin(), width * done / std::max(1, all), '#');
        std::fprintf(stderr, "\r\033[K[%s] %d of %d runs, %s", bar.c_str(), done, all, in_words(p).c_str());
        std::fflush(stderr);
    }
}

/// The strategies side by side at the finest threshold that all of them have come to, for whoever opens the picture.
SavedState state_of(const CostStudy &study, const CostRange &range, const Scene &scene,
                    const std::filesystem::path &folder) {
    SavedState saved;
    saved.scene = scene.name;
    saved.file = place_of(scene, folder);
    saved.up = up_axis(scene);
    saved.options = range.options;
    saved.options.basis = range.bases.front();
    saved.options.threshold = *std::ranges::max_element(range.thresholds);
    for (const double threshold : range.thresholds)
        if (threshold < saved.options.threshold && std::ranges::none_of(study.points, [&](const CostPoint &p) {
                return p.options.threshold == threshold && !p.done();
            }))
            saved.options.threshold = threshold;
    saved.strategies = range.strategies;
    saved.options.strategy = saved.strategies.front();
    return saved;
}

void write(const CostStudy &study, const SavedState &state, const std::filesystem::path &folder) {
    const PlotLook look{sheet_text, Theme::light};
    const glm::vec2 size(sheet_width, sheet_height);
    write_atomically(folder / "cost.csv", cost_csv(study));
    SvgCanvas svg(size.x, size.y);
    svg.fill({{0, 0}, size}, background_colour(look.theme));
    draw_cost_sheet(svg, size, study, look);
    write_atomically(folder / "cost.svg", svg.file());
    write_png(folder / "cost.png",
              draw_plot_picture(sheet_width, sheet_height, sheet_text, look.theme,
                                [&](Canvas &canvas) { draw_cost_sheet(canvas, size, study, look); }),
              state_text(state));
}

/// Whether a curve has no point at all.
bool lacks_a_curve(const CostStudy &study) {
    return std::ranges::any_of(study.points, [&](const CostPoint &p) {
        return std::ranges::none_of(study.points, [&](const CostPoint &q) {
            return q.done() && q.options.strategy == p.options.strategy && q.options.basis == p.options.basis;
        });
    });
}

int run(const CostOptions &options) {
    const std::filesystem::path folder = options.common.output;
    const auto scene = std::make_shared<const Scene>(open_scene(options.solving, options.common));
    make_folder(folder);
    const Offscreen context; // better known to be missing now than after the runs
    set_threads(options.solving.options.threads);
    const Interrupt interrupt;
    const RunLimits limits{options.solving.limits.seconds, options.solving.limits.memory_mib};

    const auto reference = reference_for(scene, options, interrupt.cancel());
    if (!reference) {
        complain(interrupt.sentence() + "; nothing was written");
        return interrupt.exit_status();
    }
    CostRange range = options.range;
    range.options = options.solving.options;
    CostStudy study{scene->name, cpu_model(), n_cores(), threads(), PENUMBRA_VERSION, range.repeats, limits, {},
                    reference->error()};
    study.points =
        measure_cost(range, solving_runner(scene, error_against(scene, reference), limits, interrupt.cancel()),
                     [&](const CostPoint &p, int done, int all) { show(options.common, p, done, all); });
    if (!options.common.quiet && !options.common.verbose && error_is_terminal())
        std::fputs("\r\033[K", stderr);
    for (const CostPoint &p : study.points)
        if (p.end == RunEnd::failed)
            complain(in_words(p) + " failed: " + p.trouble);
    const bool something = std::ranges::any_of(study.points, &CostPoint::done);
    if (something || interrupt.exit_status() == done)
        write(study, state_of(study, range, *scene, folder), folder);
    if (const int status = interrupt.exit_status(); status != done) {
        complain(interrupt.sentence() + (something ? "; what was complete is written" : "; nothing was written"));
        return status;
    }
    if (lacks_a_curve(study)) {
        complain("for a strategy not even the loosest threshold was brought to an end; raise --time-limit or "
                 "--memory-limit");
        return not_reached;
    }
    return done;
}

constexpr const char *cost_columns =
    "Columns of cost.csv, a line for each strategy, basis and threshold:\n"
    "  strategy, basis, order, threshold, max_depth\n"
    "  status: done, not converged, time limit, memory limit, failed, not tried (a looser threshold was\n"
    "    not done), interrupted\n"
    "  runs: that came to the fixed point\n"
    "  seconds, seconds_min, seconds_max: median and extremes of these; of a run that was stopped, until then.\n"
    "    Of the iterations and, for strategies that cut, of tracing the emitters' curves\n"
    "  patches, coefficients, links, kernel_evaluations: of the last complete iteration, the latter of all\n"
    "  error: relative L2, of the reflected radiosity, against the exact direct solution where light bounces once, else\n"
    "    against a reference, whose own is about reference_error\n"
    "  iterations, clips, nodes_at_limit (patches that the depth limit kept from being split)\n"
    "  scene, cpu, cores, threads, version, reference_error";

template <class T, class Named>
std::vector<T> from_names(const std::vector<std::string> &names, const Named &named) {
    std::vector<T> all;
    for (const std::string &text : names)
        if (const auto found = named(text); found && std::ranges::find(all, *found) == all.end())
            all.push_back(*found);
    return all;
}

} // namespace

Command add_cost(CLI::App &root) {
    CLI::App *parser = root.add_subcommand(
        "cost", "What accuracy costs: the true error against seconds, patches, coefficients and kernel evaluations");
    const auto options = std::make_shared<CostOptions>();
    SolvingOptions &solving = options->solving;
    CostRange &range = options->range;
    range.thresholds = {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005, 0.0002};
    solving.options.max_depth = 12;
    solving.limits.seconds = 2;
    add_scene_options(*parser, solving);
    add_solving_options(*parser, solving);
    for (const char *one : {"--strategy", "--basis", "--tolerance", "--threshold", "--time-limit", "--memory-limit"})
        parser->remove_option(parser->get_option(one));
    parser->add_option("--thresholds", range.thresholds, "Of the oracle, commas between; each is solved for")
        ->delimiter(',')
        ->check(positive())
        ->capture_default_str();
    parser->add_option("--reference", options->reference, "Tolerance of the solution that errors are measured against, where light bounces more than once; kept in the cache folder")
        ->check(positive())
        ->capture_default_str();
    parser->add_option("--repeats", range.repeats, "Times that each solution is made")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    parser
        ->add_option_function<std::vector<std::string>>(
            "--strategies",
            [&range](const std::vector<std::string> &names) { range.strategies = from_names<Strategy>(names, strategy_from_name); },
            "Names with commas between; all four unless given")
        ->delimiter(',')
        ->check(CLI::IsMember({"uniform-constant", "discontinuity-constant", "uniform-wavelet", "discontinuity-wavelet"}));
    parser
        ->add_option_function<std::vector<std::string>>(
            "--bases",
            [&range](const std::vector<std::string> &names) { range.bases = from_names<BasisFamily>(names, basis_family_from_name); },
            "parametric,planar unless given")
        ->delimiter(',')
        ->check(CLI::IsMember({"parametric", "planar"}));
    parser->add_option("--time-limit", solving.limits.seconds, "Seconds of one run, beyond which it is stopped and recorded as such (2)")
        ->check(positive())
        ->capture_default_str();
    parser->add_option("--memory-limit", solving.limits.memory_mib, "MiB of resident memory, beyond which a run is stopped and recorded as such")
        ->check(positive());
    parser->footer(cost_columns);
    add_common_options(*parser, options->common,
                       "The folder that cost.csv, cost.png and cost.svg are written to; made when it is missing");
    parser->get_option("--output")->required();
    return {parser, [=] { return run(*options); }};
}

} // namespace penumbra
