#include "capture.h"
#include "commands/command.h"
#include "commands/interrupt.h"
#include "commands/iterate.h"
#include "commands/look_options.h"
#include "commands/profile_along.h"
#include "commands/say_again.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "core/error.h"
#include "core/parallel.h"
#include "files/find_reference.h"
#include "files/open_file.h"
#include "files/picture_state.h"
#include "files/write_state.h"
#include "iteration/after_splits.h"
#include "iteration/error_map.h"
#include "measure/keyhole.h"
#include "render/picture.h"
#include "timeline.h"
#include "window/offscreen.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

namespace {

struct Pane {
    Strategy strategy{};
    bool as_quadratics = false; ///< its constants are drawn so
    bool lettered = true;
};

struct RenderOptions {
    std::vector<Pane> panes; ///< labelled; empty: the one of --strategy
    bool subtracts = false;     ///< two panes: the second minus the first is drawn
    std::optional<double> wipe; ///< two panes stand in one place, left and right of a divider there; none: side by side
    std::optional<int> steps;    ///< none: to `position`
    std::optional<int> position; ///< of a saved state, see timeline.h; none: to the fixed point
    Phase phase = Phase::pushed_pulled; ///< that the last of `steps` stops after
    std::vector<int> positions; ///< by pane; empty: all stop at the one
    RefinementPart part{};
    bool priced = true;          ///< two panes have a sentence on what they took
    std::optional<bool> price_asked; ///< said on the command line
    LookOptions look;
    /// Where they come from, for messages.
    std::string curve_field = "--curve", keyhole_field = "--keyhole", profile_field = "--profile";
};

/// What the state says, and over it what was said beside it.
void take_over(const SavedState &state, const CLI::App &parser, SolvingOptions &solving, RenderOptions &options) {
    const int threads = solving.options.threads;
    solving.options = state.options;
    solving.options.threads = threads;
    const SavedPicture picture = state.picture.value_or(SavedPicture{.lettered = true});
    if (const bool lettered = picture.lettered || state.strategies.size() > 1;
        lettered || std::ranges::count(state.reconstructed, true) > 0) {
        options.panes.clear();
        for (std::size_t i = 0; i < state.strategies.size(); ++i)
            if (state.layout != Layout::flip || static_cast<int>(i) == state.active)
                options.panes.push_back(
                    {state.strategies[i], i < state.reconstructed.size() && state.reconstructed[i], lettered});
    }
    if (state.layout == Layout::wipe)
        options.wipe = state.wipe;
    options.subtracts = state.layout == Layout::difference;
    options.look.cameras = state.cameras;
    options.priced = picture.priced;
    options.look.legend = state.legend;
    options.look.labels = picture.labels;
    options.look.caption = state.caption;
    options.look.supersample = picture.supersample;
    if (!state.converged) {
        options.position = state.position;
        if (state.layout == Layout::flip && !state.positions.empty())
            options.positions = {state.positions[static_cast<std::size_t>(state.active)]};
        else
            options.positions = state.positions;
    }
    for (const Tone &tone : state.tones) {
        options.look.exposures.push_back(tone.exposure_ev);
        options.look.ranges.push_back(tone.range);
        options.look.error_ranges.push_back(tone.error_range);
    }
    options.look.camera = state.camera;
    options.part = {state.split, state.linking};
    if (parser.count("--steps") > 0) {
        options.part = {};
        options.positions.clear();
    }
    options.look.width = picture.width;
    options.look.height = picture.height;
    options.look.look = state.look;
    options.look.keyhole = state.keyhole;
    options.look.profile = state.profile;
    say_again(parser);
    if (parser.count("--curve") == 0)
        options.curve_field = solving.scene + ": curves.shown";
    if (parser.count("--keyhole") == 0)
        options.keyhole_field = solving.scene + ": keyhole";
    if (parser.count("--profile") == 0)
        options.profile_field = solving.scene + ": profile";
    if (parser.count("--strategy") > 0 && parser.count("--panes") + parser.count("--layout") == 0)
        options.panes.clear();
    if (parser.count("--panes") > 0)
        options.priced = true;
    if (options.panes.size() != 2) { // a state's layout; other panes were asked for
        options.wipe.reset();
        options.subtracts = false;
    }
    if (parser.count("--pane-camera") == 0 && options.look.cameras.size() != options.panes.size())
        options.look.cameras.clear();
    if (parser.count("--pane-exposure") == 0 && options.look.exposures.size() != options.panes.size())
        options.look.exposures.clear();
    for (const auto &[option, ranges] : {std::pair("--pane-range", &options.look.ranges), std::pair("--pane-error-range", &options.look.error_ranges)})
        if (parser.count(option) == 0 && ranges->size() != options.panes.size())
            ranges->clear();
    if (parser.count("--pane-steps") == 0 && options.positions.size() != options.panes.size())
        options.positions.clear();
    if (options.steps)
        options.look.look.emphasise_fresh = true;
}

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

void set_panes(RenderOptions &options, const std::string &text) {
    options.panes.clear();
    for (std::size_t i = 0;; ++i) { // a strategy, perhaps a q, then a comma or the end
        const std::size_t which = i < text.size() ? std::string_view("abcd").find(text[i]) : std::string_view::npos;
        ++i;
        const bool as_quadratics = i < text.size() && text[i] == 'q';
        i += as_quadratics;
        const bool goes_on = i < text.size();
        if (which == std::string_view::npos || (goes_on && text[i] != ',') ||
            (as_quadratics && !is_constant(all_strategies[which])))
            throw CLI::ValidationError("--panes",
                                       "'" + text + "' is not a list of a, aq, b, bq, c, d with commas between");
        options.panes.push_back({.strategy = all_strategies[which], .as_quadratics = as_quadratics});
        if (!goes_on)
            return;
    }
}

constexpr double usual_wipe = 0.5;

void set_layout(RenderOptions &options, const std::string &text) {
    options.wipe = text == "wipe" ? options.wipe.value_or(usual_wipe) : std::optional<double>();
    options.subtracts = text == "difference";
    if (options.wipe || options.subtracts) {
        if (options.panes.size() != 2)
            set_panes(options, "a,d");
        return;
    }
    options.panes.clear();
    if (text == "compare")
        for (const Strategy s : all_strategies)
            options.panes.push_back({.strategy = s});
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

/// What error pictures and profiles are held against; with it goes how wrong each pane is.
Truth find_truth(const std::shared_ptr<const Scene> &scene, const Cancel &cancel, const CommonOptions &common) {
    std::optional<Progress> progress;
    if (!has_one_bounce(*scene)) {
        if (!common.quiet)
            say_notes({"solving a reference"});
        progress.emplace(Options().to_tolerance(picture_tolerance), common.quiet, common.verbose);
    }
    return truth_of(scene,
                    find_reference(scene, picture_tolerance, &cancel, [&](const Counters &c) { progress->show(c); }));
}

/// What changes of effects are told from.
Truth find_changed(const std::shared_ptr<const Scene> &scene, const Options &options, const EffectChange &change,
                   const Cancel &cancel, const CommonOptions &common) {
    if (!common.quiet)
        say_notes({"solving with " + text_of(change)});
    Progress progress(options, common.quiet, common.verbose);
    return with_change(scene, options, change, &cancel, [&](const Counters &c) { progress.show(c); });
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

/// Gives every pane its map of errors, where they are shown, and makes the profile along the line, if there is one.
std::optional<ProfileData> judge(const std::shared_ptr<const Scene> &scene, PictureSpec &spec, const Cancel &cancel,
                                 const CommonOptions &common) {
    const bool changes = spec.look.shading == Shading::error && spec.look.change;
    std::optional<Truth> truth;
    if (!(changes || spec.look.difference) || spec.profile)
        truth = find_truth(scene, cancel, common);
    if (spec.look.difference) {
        for (PicturePane &pane : spec.panes)
            pane.errors = ErrorMapper(truth_in(pane.minus)).map(*pane.snapshot, &cancel);
    } else if (changes) {
        for (PicturePane &pane : spec.panes)
            pane.errors = ErrorMapper(find_changed(scene, pane.snapshot->options, *spec.look.change, cancel, common))
                              .map(*pane.snapshot, &cancel);
    } else if (spec.look.shading == Shading::error) {
        ErrorMapper mapper(*truth);
        for (PicturePane &pane : spec.panes)
            pane.errors = mapper.map(*pane.snapshot, &cancel);
    }
    if (!spec.profile)
        return std::nullopt;
    std::vector<std::shared_ptr<const Snapshot>> solutions;
    for (const PicturePane &pane : spec.panes)
        solutions.push_back(pane.snapshot);
    return profile_along(*spec.profile, solutions, *truth, &cancel);
}

/// The first of two panes from the second.
void subtract(PictureSpec &spec) {
    const Strategy first = spec.panes[0].snapshot->options.strategy, second = spec.panes[1].snapshot->options.strategy;
    spec.look = look_at({first, second}, spec.look);
    spec.panes[1].minus = spec.panes[0].snapshot;
    spec.panes.erase(spec.panes.begin());
}

/// An error's scale has its middle at no error, and powers only of what is above 0.
void check_error_range(const Look &look) {
    if (!look.error_range)
        return;
    const Range &range = *look.error_range;
    const bool even = look.error == ErrorKind::signed_error ? std::abs(range.low + range.high) <= 1e-9 * range.high
                      : look.error == ErrorKind::estimate   ? std::abs(range.low * range.high - 1) <= 1e-9
                                                            : range.low > 0;
    if (!even)
        throw CLI::ValidationError(
            "--error-range",
            look.error == ErrorKind::signed_error ? "goes as far below 0 as above it for signed errors, as -0.5:0.5"
            : look.error == ErrorKind::estimate   ? "goes from 1/X to X for errors against the estimate, as 0.01:100"
                                                  : "is above 0 for this kind of error, as 1e-4:1");
}

/// What is given by pane is given for each.
void check_panes(const RenderOptions &options) {
    const std::size_t n = std::max<std::size_t>(1, options.panes.size());
    const bool in_one_place = options.wipe || options.subtracts;
    const auto check = [&](const char *option, std::size_t given, bool anywhere = false) {
        if (given > 0 && (given != n || (in_one_place && !anywhere)))
            throw BadInput(fmt::format("{}: there are {} for {}; give one for each of the panes{}", option, given,
                                       in_one_place && !anywhere ? "panes in one place" : fmt::format("{} pane{}", n, n == 1 ? "" : "s"),
                                       anywhere ? "" : " side by side"));
    };
    check("--pane-camera", options.look.cameras.size());
    check("--pane-exposure", options.look.exposures.size());
    check("--pane-range", options.look.ranges.size());
    check("--pane-error-range", options.look.error_ranges.size());
    check("--pane-steps", options.positions.size(), true);
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

/// "3", or "3 refine".
int position_from(const std::string &text) {
    int steps = 0;
    std::string phase;
    std::istringstream words(text);
    const std::string_view names[] = {name(Phase::refined), name(Phase::gathered), name(Phase::pushed_pulled)};
    words >> steps;
    const bool known = !words.fail();
    const bool ends = known && !(words >> phase);
    const auto found = std::ranges::find(names, phase);
    if (!known || steps < 0 || steps > 1'000'000 || (!ends && (found == std::end(names) || steps == 0)) || words >> phase)
        throw CLI::ValidationError("--pane-steps", "'" + text + "' is not a number of steps, with the phase that the last one stops after, as \"3 refine\"");
    return steps == 0 ? 0 : position_of(steps, ends ? Phase::pushed_pulled : static_cast<Phase>(1 + (found - std::begin(names))));
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
    for (const Pane &pane :
         options.panes.empty() ? std::vector{Pane{solving.options.strategy, false, false}} : options.panes) {
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
    parser
        ->add_option_function<std::string>(
            "--layout", [options](const std::string &text) { set_layout(*options, text); },
            "single (default), compare: the four strategies, labelled, or two of them (--panes) in one picture: wipe, one left "
            "of a divider and one right of it, or difference, the second minus the first")
        ->check(CLI::IsMember({"single", "compare", "wipe", "difference"}));
    parser
        ->add_option_function<double>(
            "--wipe",
            [options](double share) {
                set_layout(*options, "wipe");
                options->wipe = share;
            },
            "Layout wipe with its divider there, from 0 at the left to 1 at the right [0.5]")
        ->check(CLI::Range(0.0, 1.0));
    parser->add_option_function<std::string>(
        "--panes", [options](const std::string &text) { set_panes(*options, text); },
        "These strategies side by side, of a, b, c, d with commas between; two of them with a sentence on their price. aq "
        "and bq draw the constants as quadratics made for the eye, as in 1993");
    parser->add_option("--steps", options->steps, "Steps to do; to the fixed point unless given")
        ->check(CLI::Range(0, 1'000'000));
    parser
        ->add_option_function<std::vector<std::string>>(
            "--pane-steps",
            [options](const std::vector<std::string> &texts) {
                options->positions.clear();
                for (const std::string &text : texts)
                    options->positions.push_back(position_from(text));
            },
            "Steps of one of the panes, and the phase that the last one stops after, as \"3 refine\"; given for each of them, in "
            "their order")
        ->allow_extra_args(false)
        ->excludes("--steps");
    parser
        ->add_option_function<std::string>(
            "--phase",
            [options](const std::string &text) {
                options->phase = text == name(Phase::refined)    ? Phase::refined
                                 : text == name(Phase::gathered) ? Phase::gathered
                                                                 : Phase::pushed_pulled;
            },
            "The last of the steps stops after refine, gather, or push-pull (default)")
        ->check(CLI::IsMember({std::string(name(Phase::refined)), std::string(name(Phase::gathered)),
                               std::string(name(Phase::pushed_pulled))}))
        ->needs("--steps");
    const auto split = parser->add_option("--split", options->part.splits, "After so many splits of the refinement, where that stops");
    split->check(CLI::PositiveNumber)->needs("--phase");
    parser->add_option("--link", options->part.linkings, "After all its splits, and so many of the pairs that it linked")
        ->check(CLI::PositiveNumber)
        ->needs("--phase")
        ->excludes(split);
    parser->add_flag_function(
        "--price,!--no-price", [options](std::int64_t n) { options->price_asked = n > 0; },
        "A sentence on what two panes took [where --panes is given]");
    add_look_options(*parser, options->look);
    add_solving_options(*parser, *solving);
    add_common_options(*parser, *common, "The picture, a PNG");
    parser->get_option("--output")->required();
    parser->final_callback([options] {
        if (options->subtracts)
            options->look.look = look_at({}, options->look.look); // whose errors are signed
        check_error_range(options->look.look);
        if ((options->wipe || options->subtracts) && options->panes.size() != 2)
            throw CLI::ValidationError("--layout", "this one compares two strategies; give two to --panes, as a,d");
    });
    return {parser, [=] { return run(*parser, *solving, *options, *common); }};
}

} // namespace penumbra
