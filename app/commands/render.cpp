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
#include "measure/keyhole.h"
#include "render/picture.h"
#include "window/offscreen.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

namespace {

struct RenderOptions {
    std::vector<Strategy> panes; ///< side by side, labelled; empty: the one of --strategy
    std::optional<int> steps;    ///< none: to the fixed point
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

/// BadInput where there is no surface that reflects.
std::shared_ptr<const Keyhole> look_from(const std::shared_ptr<const Scene> &scene, const Vec3 &point) {
    const KeyholeEye eye(scene);
    const SurfaceId surface = eye.surface_at(point, 1e-3);
    if (!surface.valid())
        throw BadInput(
            "--keyhole: no surface that reflects lies within a thousandth of the scene's size of this point; "
            "give a point of a floor, a wall, a table");
    return std::make_shared<const Keyhole>(eye.look(surface, point));
}

std::string tag_of(Strategy strategy) { return std::string("(") + "abcd"[static_cast<int>(strategy)] + ")"; }

void set_panes(RenderOptions &options, const std::string &text) {
    options.panes.clear();
    for (std::size_t i = 0;; i += 2) { // a strategy, then a comma or the end
        const std::size_t which = i < text.size() ? std::string_view("abcd").find(text[i]) : std::string_view::npos;
        const bool goes_on = i + 1 < text.size();
        if (which == std::string_view::npos || (goes_on && text[i + 1] != ','))
            throw CLI::ValidationError("--panes", "'" + text + "' is not a list of a, b, c, d with commas between");
        options.panes.push_back(all_strategies[which]);
        if (!goes_on)
            return;
    }
}

/// What each of two solutions took for its error; `tracing` is the time in which the curves were found [s].
std::string price(const Snapshot &one, const Snapshot &other, double tracing) {
    if (!(one.error >= 0) || !(other.error >= 0) || !(one.counters.seconds > 0))
        return {};
    const auto time = [](double s) {
        return s < 0.0995 ? fmt::format("{:.2g} ms", 1e3 * s) : fmt::format("{:.2g} s", s);
    };
    const auto part = [&](const Snapshot &s) {
        return fmt::format("{} has an error of {:.2g} % with {} coefficients after {}", tag_of(s.options.strategy),
                           100 * s.error, s.counters.coefficients, time(s.counters.seconds));
    };
    const double ratio = other.counters.seconds / one.counters.seconds;
    const Snapshot &slower = ratio < 1 ? one : other;
    return fmt::format("{}, {}. So {} takes {:.2g} times as long, and {} more to find {} curves.", part(one),
                       part(other), tag_of(slower.options.strategy), std::max(ratio, 1 / ratio), time(tracing),
                       one.curves->size());
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
    spec.columns = options.panes.size() > 1 ? 2 : 1;
    bool converged = true;
    double tracing = 0;
    for (const Strategy strategy : options.panes.empty() ? std::vector{solving.options.strategy} : options.panes) {
        Options o = solving.options;
        o.strategy = strategy;
        try {
            const auto start = std::chrono::steady_clock::now();
            Solver solver(scene, o, &interrupt.cancel());
            tracing = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            Progress progress(o, common.quiet, common.verbose);
            iterate(solver, options.steps.value_or(o.max_iterations), interrupt.cancel(), progress);
            converged &= solver.converged();
            const std::string tag = options.panes.empty() ? "" : tag_of(strategy);
            spec.panes.push_back({solver.snapshot(interrupt.exit_status() == done), tag});
        } catch (const Cancelled &) { // while the curves were made: there is nothing to draw
            complain("stopped before there was anything to draw");
            return interrupt.exit_status();
        }
    }
    const Snapshot &first = *spec.panes.front().snapshot;
    choose_curves(options.look, first, spec.look);
    if (options.panes.size() == 2)
        spec.caption = price(*spec.panes[0].snapshot, *spec.panes[1].snapshot, tracing);
    if (options.look.keyhole)
        spec.keyhole = look_from(scene, *options.look.keyhole);
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
            "--layout",
            [options](const std::string &text) {
                options->panes.clear();
                if (text == "compare")
                    options->panes.assign(std::begin(all_strategies), std::end(all_strategies));
            },
            "single (default), or compare: the four strategies, labelled")
        ->check(CLI::IsMember({"single", "compare"}));
    parser->add_option_function<std::string>(
        "--panes", [options](const std::string &text) { set_panes(*options, text); },
        "These strategies side by side, of a, b, c, d with commas between; two of them with a sentence on their price");
    parser->add_option("--steps", options->steps, "Steps to do; to the fixed point unless given")
        ->check(CLI::Range(0, 1'000'000));
    add_look_options(*parser, options->look);
    add_solving_options(*parser, *solving);
    add_common_options(*parser, *common, "The picture, a PNG");
    parser->get_option("--output")->required();
    return {parser, [=] { return run(*solving, *options, *common); }};
}

} // namespace penumbra
