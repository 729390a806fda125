#include "commands/render_options.h"

#include "commands/say_again.h"
#include "core/error.h"
#include "timeline.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

namespace penumbra {

namespace {

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

} // namespace

void add_render_options(CLI::App &parser, RenderOptions &options) {
    parser
        .add_option_function<std::string>(
            "--layout", [&options](const std::string &text) { set_layout(options, text); },
            "single (default), compare: the four strategies, labelled, or two of them (--panes) in one picture: wipe, one left "
            "of a divider and one right of it, or difference, the second minus the first")
        ->check(CLI::IsMember({"single", "compare", "wipe", "difference"}));
    parser
        .add_option_function<double>(
            "--wipe",
            [&options](double share) {
                set_layout(options, "wipe");
                options.wipe = share;
            },
            "Layout wipe with its divider there, from 0 at the left to 1 at the right [0.5]")
        ->check(CLI::Range(0.0, 1.0));
    parser.add_option_function<std::string>(
        "--panes", [&options](const std::string &text) { set_panes(options, text); },
        "These strategies side by side, of a, b, c, d with commas between; two of them with a sentence on their price. aq "
        "and bq draw the constants as quadratics made for the eye, as in 1993");
    parser.add_option("--steps", options.steps, "Steps to do; to the fixed point unless given")
        ->check(CLI::Range(0, 1'000'000));
    parser
        .add_option_function<std::vector<std::string>>(
            "--pane-steps",
            [&options](const std::vector<std::string> &texts) {
                options.positions.clear();
                for (const std::string &text : texts)
                    options.positions.push_back(position_from(text));
            },
            "Steps of one of the panes, and the phase that the last one stops after, as \"3 refine\"; given for each of them, in "
            "their order")
        ->allow_extra_args(false)
        ->excludes("--steps");
    parser
        .add_option_function<std::string>(
            "--phase",
            [&options](const std::string &text) {
                options.phase = text == name(Phase::refined)    ? Phase::refined
                                 : text == name(Phase::gathered) ? Phase::gathered
                                                                 : Phase::pushed_pulled;
            },
            "The last of the steps stops after refine, gather, or push-pull (default)")
        ->check(CLI::IsMember({std::string(name(Phase::refined)), std::string(name(Phase::gathered)),
                               std::string(name(Phase::pushed_pulled))}))
        ->needs("--steps");
    const auto split = parser.add_option("--split", options.part.splits, "After so many splits of the refinement, where that stops");
    split->check(CLI::PositiveNumber)->needs("--phase");
    parser.add_option("--link", options.part.linkings, "After all its splits, and so many of the pairs that it linked")
        ->check(CLI::PositiveNumber)
        ->needs("--phase")
        ->excludes(split);
    parser.add_flag_function(
        "--price,!--no-price", [&options](std::int64_t n) { options.price_asked = n > 0; },
        "A sentence on what two panes took [where --panes is given]");
    add_look_options(parser, options.look);
    parser.final_callback([&options] {
        if (options.subtracts)
            options.look.look = look_at({}, options.look.look); // whose errors are signed
        check_error_range(options.look.look);
        if ((options.wipe || options.subtracts) && options.panes.size() != 2)
            throw CLI::ValidationError("--layout", "this one compares two strategies; give two to --panes, as a,d");
    });
}

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

} // namespace penumbra
