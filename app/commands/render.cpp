#include "capture.h"
#include "commands/command.h"
#include "commands/interrupt.h"
#include "commands/iterate.h"
#include "commands/look_options.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "core/error.h"
#include "core/parallel.h"
#include "files/picture_state.h"
#include "render/picture.h"
#include "window/offscreen.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include <memory>
#include <optional>
#include <string>

namespace penumbra {

namespace {

struct RenderOptions {
    bool compare = false;     ///< the four strategies side by side
    std::optional<int> steps; ///< none: to the fixed point
    LookOptions look;
};

/// The surface of that number, or the first of that name; BadInput when there is none.
int find_surface(const Snapshot &snapshot, const std::string &text) {
    for (std::size_t i = 0; i < snapshot.surfaces.size(); ++i)
        if (text == std::to_string(i) || text == snapshot.surfaces[i].name)
            return static_cast<int>(i);
    throw BadInput("--curve-source " + text + ": the scene has no surface of that name or number; there are " +
                   std::to_string(snapshot.surfaces.size()) + ", counted from 0");
}

/// What the options say of curves, now that these are known.
void choose_curves(const LookOptions &options, const Snapshot &snapshot, Look &look) {
    if (!options.curve_source.empty())
        look.curve_filter.source = find_surface(snapshot, options.curve_source);
    if (const auto n = static_cast<int>(snapshot.curves->size()); look.spotlight.curve >= n)
        throw BadInput("--curve " + std::to_string(look.spotlight.curve) + ": the scene has " + std::to_string(n) +
                       " curves, counted from 0; 'penumbra curves' lists them");
}

int run(const SolvingOptions &solving, const RenderOptions &options, const CommonOptions &common) {
    check_deliverable(common.output);
    const auto scene = std::make_shared<const Scene>(open_scene(solving, common));
    const Offscreen context; // before the work: where there is no GL, it would be for nothing
    set_threads(solving.options.threads);
    const Interrupt interrupt(solving.time_limit);

    PictureSpec spec;
    spec.width = options.look.width;
    spec.height = options.look.height;
    spec.look = options.look.look;
    spec.columns = options.compare ? 2 : 1;
    bool converged = true;
    for (const Strategy strategy : all_strategies) {
        if (!options.compare && strategy != solving.options.strategy)
            continue;
        Options o = solving.options;
        o.strategy = strategy;
        try {
            Solver solver(scene, o, &interrupt.cancel());
            Progress progress(o, common.quiet, common.verbose);
            iterate(solver, options.steps.value_or(o.max_iterations), interrupt.cancel(), progress);
            converged &= solver.converged();
            const std::string tag = options.compare ? std::string("(") + "abcd"[static_cast<int>(strategy)] + ")" : "";
            spec.panes.push_back({solver.snapshot(interrupt.exit_status() == done), tag});
        } catch (const Cancelled &) { // while the curves were made: there is nothing to draw
            complain("stopped before there was anything to draw");
            return interrupt.exit_status();
        }
    }
    const Snapshot &first = *spec.panes.front().snapshot;
    choose_curves(options.look, first, spec.look);
    Scene seen = *scene;
    if (options.look.view)
        seen.view = options.look.view;
    spec.camera = first_view(seen, first, pane_aspect(spec));
    // The step's news are of interest while stepping; in a finished solution they would be whatever came last.
    spec.look.emphasise_fresh = options.steps.has_value();
    write_png(common.output, draw_picture(spec), picture_state(spec, scene->file));

    if (const int status = interrupt.exit_status(); status != done) {
        complain("stopped early; the picture shows the last complete solution");
        return status;
    }
    if (!converged && !options.steps) {
        complain("the fixed point was not reached in " + std::to_string(solving.options.max_iterations) +
                 " iterations; raise --max-iterations or --threshold");
        return not_reached;
    }
    return done;
}

} // namespace

Command add_render(CLI::App &root) {
    CLI::App *parser = root.add_subcommand("render", "Draws a picture with no window");
    const auto solving = std::make_shared<SolvingOptions>();
    const auto common = std::make_shared<CommonOptions>();
    const auto options = std::make_shared<RenderOptions>();
    add_scene_options(*parser, *solving);
    parser
        ->add_option_function<std::string>(
            "--layout", [options](const std::string &text) { options->compare = text == "compare"; },
            "single (default), or compare: the four strategies, labelled")
        ->check(CLI::IsMember({"single", "compare"}));
    parser->add_option("--steps", options->steps, "Steps to do; to the fixed point unless given")
        ->check(CLI::Range(0, 1'000'000));
    add_look_options(*parser, options->look);
    add_solving_options(*parser, *solving);
    add_common_options(*parser, *common, "The picture, a PNG");
    parser->get_option("--output")->required();
    return {parser, [=] { return run(*solving, *options, *common); }};
}

} // namespace penumbra
