#include "capture.h"
#include "commands/command.h"
#include "commands/interrupt.h"
#include "commands/iterate.h"
#include "commands/judge_picture.h"
#include "commands/render_options.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "core/error.h"
#include "core/parallel.h"
#include "files/open_file.h"
#include "files/picture_state.h"
#include "files/write_state.h"
#include "iteration/after_splits.h"
#include "measure/keyhole.h"
#include "render/picture.h"
#include "timeline.h"
#include "window/offscreen.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

namespace {

/// The surface of that number, or the first of that name; BadInput when there is none.
int find_surface(const Snapshot &snapshot, const std::string &text) {
    for (std::size_t i = 0; i < snapshot.surfaces.size(); ++i)
        if (text == std::to_string(i) || text == snapshot.surfaces[i].name)
            return static_cast<int>(i);
    throw BadInput("--curve-source " + text + ": the scene has no surface of that name or number; there are " +
                   std::to_string(snapshot.surfaces.size()) + ", counted from 0");
}

/// What the options say of curves, now that these are known.
void choose_curves(const RenderOptions &options, const Snapshot &snapshot, Look &look) {
    if (!options.look.curve_source.empty())
        look.curve_filter.source = find_surface(snapshot, options.look.curve_source);
    if (const auto n = static_cast<int>(snapshot.curves->size()); look.spotlight.curve >= n)
        throw BadInput(options.curve_field + " " + std::to_string(look.spotlight.curve) + ": the scene has " +
                       std::to_string(n) + " curves, counted from 0; 'penumbra curves' lists them");
}

/// BadInput where there is no surface that reflects.
std::shared_ptr<const Keyhole> look_from(const std::shared_ptr<const Scene> &scene, const Vec3 &point,
                                         const std::string &field) {
    const KeyholeEye eye(scene);
    const SurfaceId surface = eye.surface_at(point, 1e-3);
    if (!surface.valid())
        throw BadInput(field + ": no surface that reflects lies within a thousandth of the scene's size of this point; "
                               "give a point of a floor, a wall, a table");
    return std::make_shared<const Keyhole>(eye.look(surface, point));
}

Camera camera_of(const RenderOptions &options, const Scene &scene, const Snapshot &snapshot, double aspect) {
    if (options.look.camera && !options.look.view)
        return *options.look.camera;
    Scene seen = scene;
    if (options.look.view)
        seen.view = options.look.view;
    return first_view(seen, snapshot, aspect);
}

/// As it was to be shown: perhaps with a part of a refinement alone.
std::shared_ptr<const Snapshot> shown(std::shared_ptr<const Snapshot> snapshot, const RenderOptions &options) {
    const auto part = part_of(*snapshot, options.part);
    return part ? part : snapshot;
}

std::string tag_of(Strategy strategy) { return std::string("(") + "abcd"[static_cast<int>(strategy)] + ")"; }

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

/// Steps to the position asked for, of the pane where it has its own; the last iteration may stop after a phase.
void go(Solver &solver, const RenderOptions &options, std::size_t pane, const Cancel &cancel, Progress &progress) {
    const int most = solver.options().max_iterations;
    const int position = !options.positions.empty() ? options.positions[pane] : options.steps ? position_of(*options.steps, *options.steps == 0 ? Phase::start : options.phase) : options.position.value_or(step_position(most));
    iterate(solver, position / phases_per_iteration, cancel, progress);
    const auto complete = solver.state();
    try {
        for (int i = 0; i < position % phases_per_iteration && !solver.ended() && !cancel.raised(); ++i)
            solver.sub_step(&cancel);
    } catch (const Cancelled &) {
        solver.restore(complete);
    }
}

/// The first of two panes from the second.
void subtract(PictureSpec &spec) {
    const Strategy first = spec.panes[0].snapshot->options.strategy, second = spec.panes[1].snapshot->options.strategy;
    spec.look = look_at({first, second}, spec.look);
    spec.panes[1].minus = spec.panes[0].snapshot;
    spec.panes.erase(spec.panes.begin());
}

/// What is not given by pane is the look's, but for ranges: then each pane has its own.
void set_tones(PictureSpec &spec, const LookOptions &look) {
    if (look.exposures.empty() && look.ranges.empty() && look.error_ranges.empty())
        return;
    for (std::size_t i = 0; i < spec.panes.size(); ++i) {
        Tone tone{look.look.exposure_ev, look.look.range, look.look.error_range};
        if (!look.exposures.empty())
            tone.exposure_ev = look.exposures[i];
        if (!look.ranges.empty())
            tone.range = look.ranges[i];
        if (!look.error_ranges.empty())
            tone.error_range = look.error_ranges[i];
        tone.range_chosen = tone.range.has_value();
        tone.error_range_locked = tone.error_range.has_value();
        spec.panes[i].tone = tone;
    }
}

int run(const CLI::App &parser, SolvingOptions &solving, RenderOptions &options, const CommonOptions &common) {
    check_deliverable(common.output);
    const OpenedFile opened = open_file(solving.scene, solving.up_vector(), solving.moves);
    if (!common.quiet)
        say_notes(opened.notes());
    const std::shared_ptr<const Scene> &scene = opened.scene;
    options.look.look.emphasise_fresh = options.steps.has_value();
    if (opened.state)
        take_over(*opened.state, parser, solving, options);
    options.look.look.emphasise_fresh = options.look.fresh.value_or(options.look.look.emphasise_fresh);
    options.priced = options.price_asked.value_or(options.priced);
    const Offscreen context; // before the work: where there is no GL, it would be for nothing
    set_threads(solving.options.threads);
    const Interrupt interrupt(solving.limits);

    PictureSpec spec;
    spec.width = options.look.width;
    spec.height = options.look.height;
    spec.look = options.look.look;
    spec.labels = options.look.labels;
    spec.caption = options.look.caption;
    spec.legend = options.look.legend;
    spec.supersample = options.look.supersample;
    spec.wipe = options.wipe;
    spec.columns = options.panes.size() > 1 && !spec.wipe && !options.subtracts ? 2 : 1;
    check_panes(options);
    bool converged = true;
    std::string out_of_reach; // why, where a solution cannot come to the tolerance
    double tracing = 0;
    for (const AskedPane &pane :
         options.panes.empty() ? std::vector{AskedPane{solving.options.strategy, false, false}} : options.panes) {
        Options o = solving.options;
        o.strategy = pane.strategy;
        try {
            const auto start = std::chrono::steady_clock::now();
            Solver solver(scene, o, &interrupt.cancel());
            tracing = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            Progress progress(o, common.quiet, common.verbose);
            go(solver, options, spec.panes.size(), interrupt.cancel(), progress);
            converged &= solver.converged();
            const bool with_error = interrupt.exit_status() == done;
            spec.panes.push_back({pane.as_quadratics
                                      ? solver.reconstruction(*solver.state(), with_error, &interrupt.cancel())
                                      : shown(solver.snapshot(with_error), options),
                                  pane.lettered ? tag_of(pane.strategy) : ""});
            if (solver.counters().exhausted)
                out_of_reach = spec.panes.back().snapshot->sentence;
        } catch (const Cancelled &) { // while the curves were made: there is nothing to draw
            complain(interrupt.sentence() + " before there was anything to draw; nothing was written");
            return interrupt.exit_status();
        }
    }
    const Snapshot &first = *spec.panes.front().snapshot;
    choose_curves(options, first, spec.look);
    if (options.panes.size() == 2 && options.priced && options.positions.empty() && !options.panes[0].as_quadratics && !options.panes[1].as_quadratics)
        spec.price = price(*spec.panes[0].snapshot, *spec.panes[1].snapshot, tracing);
    if (options.subtracts)
        subtract(spec);
    for (std::size_t i = 0; i < options.look.cameras.size(); ++i)
        spec.panes[i].camera = options.look.cameras[i];
    set_tones(spec, options.look);
    if (options.look.keyhole)
        spec.keyhole = look_from(scene, *options.look.keyhole, options.keyhole_field);
    std::optional<ProfileData> profile;
    try {
        if (options.look.profile)
            spec.profile = find_line(first, options.look.profile->first, options.look.profile->second, scene->own.size,
                                     options.profile_field);
        if (spec.look.shading == Shading::error || spec.profile)
            profile = judge(scene, spec, interrupt.cancel(), common);
    } catch (const Cancelled &) {
        complain(interrupt.sentence() +
                 " before it was known what errors are measured against; nothing was written");
        return interrupt.exit_status();
    }
    spec.camera = camera_of(options, *scene, first, pane_aspect(spec));
    SavedState saved = picture_state(spec, *scene, std::filesystem::path(common.output).parent_path(), !options.positions.empty());
    saved.moves = opened.moves;
    write_png(common.output, draw_picture(spec), state_text(saved));
    if (profile)
        write_profile(common.output, *spec.profile, *profile, spec.look.theme);

    if (const int status = interrupt.exit_status(); status != done) {
        complain(fmt::format("{}; the picture shows the last complete solution, of iteration {}", interrupt.sentence(),
                             first.counters.iteration));
        return status;
    }
    if (!converged && !options.steps && !options.position && options.positions.empty()) {
        complain(!out_of_reach.empty() ? out_of_reach
                                       : "the fixed point was not reached in " +
                                             std::to_string(solving.options.max_iterations) +
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
    parser
        ->add_option("FILE", solving->scene,
                     "An OBJ or glTF file, the name of a bundled scene, a saved state (.penumbra.json), or a PNG that "
                     "Penumbra wrote; options beside a state go before it")
        ->required();
    add_up_option(*parser, *solving);
    add_render_options(*parser, *options);
    add_solving_options(*parser, *solving);
    add_common_options(*parser, *common, "The picture, a PNG");
    parser->get_option("--output")->required();
    return {parser, [=] { return run(*parser, *solving, *options, *common); }};
}

} // namespace penumbra
