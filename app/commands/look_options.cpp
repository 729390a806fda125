#include "commands/look_options.h"

#include "core/read_text.h"
#include "files/read_state.h"
#include "scene/obj_header.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace penumbra {

namespace {

/// The whole text as a number, or nothing.
template <class Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

[[noreturn]] void refuse(const char *option, const std::string &text, const char *wanted) {
    throw CLI::ValidationError(option, "'" + text + "' is not " + wanted);
}

void set_size(LookOptions &options, const std::string &text) {
    const std::size_t by = text.find('x');
    const auto width = number<int>(std::string_view(text).substr(0, by));
    const auto height = by == text.npos ? std::nullopt : number<int>(std::string_view(text).substr(by + 1));
    const auto fits = [](int n) { return n >= smallest_picture && n <= largest_picture; };
    if (!width || !height || !fits(*width) || !fits(*height))
        refuse("--size", text, "WIDTHxHEIGHT in pixels, from 64 to 16384 each, as 1280x960");
    options.width = *width;
    options.height = *height;
}

void set_layers(LookOptions &options, const std::string &text) {
    Layers layers{false, false, false};
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        const std::string_view name = std::string_view(text).substr(from, comma - from);
        if (name == "mesh")
            layers.mesh = true;
        else if (name == "curves")
            layers.curves = true;
        else if (name == "links")
            layers.links = true;
        else if (!(name.empty() || name == "none"))
            refuse("--layers", text, "a list of mesh, curves, links with commas between, or none");
        from = comma + 1;
    }
    options.look.layers = layers;
}

/// Sets those flags that the list names; none of them where it is the word none.
template <std::size_t n>
void set_flags(const char *option, const std::string &text, const std::array<std::string_view, n> &names,
               std::array<bool, n> &flags) {
    flags.fill(false);
    if (text == "none")
        return;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        const auto found = std::ranges::find(names, std::string_view(text).substr(from, comma - from));
        if (found == names.end()) {
            std::string known;
            for (const std::string_view name : names)
                known.append(known.empty() ? "" : ", ").append(name);
            refuse(option, text, ("a list of " + known + " with commas between, or none").c_str());
        }
        flags[static_cast<std::size_t>(found - names.begin())] = true;
        from = comma + 1;
    }
}

/// n finite numbers with space between, or nothing.
template <int n>
std::optional<Eigen::Matrix<double, n, 1>> numbers(const std::string &text) {
    const auto words = words_of(text);
    Eigen::Matrix<double, n, 1> all;
    if (words.size() != n)
        return std::nullopt;
    for (std::size_t i = 0; i < n; ++i)
        if (!number_from(words[i], all[static_cast<Eigen::Index>(i)]) ||
            !std::isfinite(all[static_cast<Eigen::Index>(i)]))
            return std::nullopt;
    return all;
}

void set_keyhole(LookOptions &options, const std::string &text) {
    options.keyhole = numbers<3>(text);
    if (!options.keyhole)
        refuse("--keyhole", text, "\"x y z\", a point on a surface");
}

void set_profile(LookOptions &options, const std::string &text) {
    const auto ends = numbers<6>(text);
    if (!ends)
        refuse("--profile", text, "\"x y z x y z\", two points of one surface");
    options.profile = std::pair(Vec3(ends->head<3>()), Vec3(ends->tail<3>()));
}

/// What read_state refuses is refused here, too.
Camera camera_from_text(const char *option, const std::string &text) {
    const auto given = numbers<10>(text);
    if (!given)
        refuse(option, text, "\"ex ey ez tx ty tz ux uy uz fov\": eye, target, up, and the vertical angle in degrees");
    const auto triple = [&](int at) { return glm::dvec3((*given)[at], (*given)[at + 1], (*given)[at + 2]); };
    Camera camera{triple(0), triple(3), triple(6), (*given)[9]};
    const double up = glm::length(camera.up), away = glm::distance(camera.eye, camera.target);
    if (!(camera.fov_y >= 0.01 && camera.fov_y <= 175) || !(up > 0) || !(away > 0) ||
        !(glm::length(glm::cross((camera.target - camera.eye) / away, camera.up / up)) > 1e-9))
        refuse(option, text, "a view: the eye is not in its target nor looks along its up, and the angle is from 0.01 to 175");
    if (std::abs(up - 1) > 1e-9)
        camera.up /= up;
    return camera;
}

void add_curve_options(CLI::App &parser, LookOptions &options) {
    constexpr std::array<std::string_view, 5> kinds{"VE", "EV", "EEE", "plane", "contact"};
    constexpr std::array<std::string_view, 3> orders{"0", "1", "2"};
    CurveFilter &filter = options.look.curve_filter;
    parser.add_option_function<std::string>(
        "--curve-kinds",
        [=, &filter](const std::string &text) { set_flags("--curve-kinds", text, kinds, filter.kinds); },
        "Draws these curves alone: of VE, EV, EEE, plane, contact, with commas between, or none");
    parser.add_option_function<std::string>(
        "--curve-orders",
        [=, &filter](const std::string &text) { set_flags("--curve-orders", text, orders, filter.orders); },
        "Draws curves of these orders alone: of 0, 1, 2, with commas between, or none");
    parser.add_option("--curve-source", options.curve_source,
                      "Draws curves of this source alone: a surface's number, or its object's name");
    parser
        .add_option(
            "--curve", options.look.spotlight.curve,
            "Shows this curve (its number in the output of 'curves') with its critical surface, and says what it is")
        ->check(CLI::NonNegativeNumber);
    parser.add_option_function<std::string>(
        "--keyhole", [&](const std::string &text) { set_keyhole(options, text); },
        "\"x y z\": shows beside the picture what is seen of each emitter from this point of a surface");
    parser.add_option_function<std::string>(
        "--profile", [&](const std::string &text) { set_profile(options, text); },
        "\"x y z x y z\": draws the line between two points of a surface, and the radiosity along it, true and solved, "
        "into "
        "OUT-profile.png, .svg and .csv beside the picture");
}

std::optional<Range> range_from(const std::string &text) {
    const std::size_t colon = text.find(':');
    const auto low = number<double>(std::string_view(text).substr(0, colon));
    const auto high = colon == text.npos ? std::nullopt : number<double>(std::string_view(text).substr(colon + 1));
    if (!low || !high || !std::isfinite(*low) || !std::isfinite(*high) || !(*low < *high))
        return std::nullopt;
    return Range{*low, *high};
}

void set_range(LookOptions &options, const std::string &text) {
    options.look.range = range_from(text);
    if (!options.look.range)
        refuse("--range", text, "LOW:HIGH in W/m\u00b2 with LOW below HIGH, as 0:12.5");
}

Range error_range_from(const char *option, const std::string &text) {
    const auto range = range_from(text);
    if (!range)
        refuse(option, text, "LOW:HIGH with LOW below HIGH, as -0.5:0.5 (signed) or 1e-4:1");
    return *range;
}

void add_pane_ranges(CLI::App &parser, const char *option, std::vector<std::optional<Range>> &ranges, const char *help) {
    parser
        .add_option_function<std::vector<std::string>>(
            option,
            [&ranges, option](const std::vector<std::string> &texts) {
                ranges.clear();
                for (const std::string &text : texts) {
                    const auto range = range_from(text);
                    if (!range && text != "own")
                        refuse(option, text, "LOW:HIGH with LOW below HIGH, as 0:12.5, or own");
                    ranges.push_back(range);
                }
            },
            help)
        ->allow_extra_args(false);
}

} // namespace

void add_look_options(CLI::App &parser, LookOptions &options) {
    parser.add_option_function<std::string>(
        "--size", [&](const std::string &text) { set_size(options, text); },
        "WIDTHxHEIGHT in pixels, from 64 to 16384 each [1280x960]");
    parser
        .add_option("--supersample", options.supersample,
                    "Drawn so many times larger, 1 to 4, and averaged as light: smooth lines and shadow edges")
        ->check(CLI::Range(1, most_supersampling))
        ->capture_default_str();
    parser.add_flag("--transparent,!--no-transparent", options.look.transparent,
                    "Nothing is drawn where there is no surface (a PNG with alpha); words stand on plates of the "
                    "background's colour");
    parser.add_flag("--labels,!--no-labels", options.labels, "Strategy and figures over each pane [yes]");
    parser.add_flag("--legend,!--no-legend", options.legend, "Scales and line kinds below the panes [yes]");
    parser.add_flag_function(
        "--fresh,!--no-fresh", [&](std::int64_t n) { options.fresh = n > 0; },
        "Patches that the last refinement made stand out [where --steps is given]");
    parser.add_option_function<std::string>(
        "--layers", [&](const std::string &text) { set_layers(options, text); },
        "Of mesh, curves, links, with commas between, or none [mesh,curves]");
    add_curve_options(parser, options);
    parser
        .add_option_function<std::string>(
            "--shading", [&](const std::string &text) { options.look.shading = *shading_from_name(text); },
            "polynomial (default: the solution itself), flat, linear, or error: how wrong it is")
        ->check(CLI::IsMember({"polynomial", "flat", "linear", "error"}));
    parser
        .add_option_function<std::string>(
            "--error",
            [&](const std::string &text) {
                const ErrorKind kind = *error_kind_from_name(text);
                if (kind != options.look.error)
                    options.look.error_range.reset(); // a state's, of another kind
                options.look.error = kind;
            },
            "What --shading error shows: signed (default: solution minus truth), relative (its size over the largest "
            "reflected radiosity), patch (the L2 error of each patch) or estimate (that over what the oracle saw)")
        ->check(CLI::IsMember({"signed", "relative", "patch", "estimate"}));
    parser.add_option_function<std::string>(
        "--change",
        [&](const std::string &text) {
            options.look.change = effect_change_from(text);
            if (!options.look.change)
                refuse("--change", text, "an effect's name with =on or =off, as visibility=off");
            options.look.shading = Shading::error;
        },
        "NAME=on|off: errors from the same solution with this effect switched so, in place of the truth: what the effect changes");
    parser.add_option_function<std::string>(
        "--error-range",
        [&](const std::string &text) { options.look.error_range = error_range_from("--error-range", text); },
        "LOW:HIGH of the error's scale, in W/m\u00b2 (signed) or as a share or ratio above 0; from the values unless "
        "given");
    parser.add_option_function<std::string>(
        "--view",
        [&](const std::string &text) {
            options.view = view_from(text);
            if (!options.view)
                refuse("--view", text, "\"ex ey ez tx ty tz fov\": eye, target, and the vertical angle in degrees");
        },
        "\"ex ey ez tx ty tz fov\": eye, target, vertical angle [degrees]; the scene's own unless given");
    parser
        .add_option_function<std::string>(
            "--camera", [&](const std::string &text) { options.camera = camera_from_text("--camera", text); },
            "\"ex ey ez tx ty tz ux uy uz fov\": as --view with the up direction, and just so whatever the picture's "
            "shape, where --view steps back for narrow ones")
        ->excludes("--view");
    parser
        .add_option_function<std::vector<std::string>>(
            "--pane-camera",
            [&](const std::vector<std::string> &texts) {
                options.cameras.clear();
                for (const std::string &text : texts)
                    options.cameras.push_back(camera_from_text("--pane-camera", text));
            },
            "As --camera, for one of the panes side by side; given for each of them, in their order")
        ->allow_extra_args(false);
    parser.add_option("--caption", options.caption, "A sentence below the panes");
    parser.add_option("--exposure", options.look.exposure_ev, "EV: radiosity is shown 2^EV times as bright")
        ->check(CLI::Range(-40.0, 40.0))
        ->capture_default_str();
    parser
        .add_option("--pane-exposure", options.exposures,
                    "As --exposure, for one of the panes side by side; given for each of them, in their order")
        ->check(CLI::Range(-40.0, 40.0))
        ->allow_extra_args(false);
    add_pane_ranges(parser, "--pane-range", options.ranges,
                    "As --range, or own: what this one of the panes side by side shows; given for each of them, in their order");
    add_pane_ranges(parser, "--pane-error-range", options.error_ranges,
                    "As --error-range, or own, for one of the panes side by side; given for each of them, in their order");
    parser.add_option_function<std::string>(
        "--range", [&](const std::string &text) { set_range(options, text); },
        "LOW:HIGH [W/m\u00b2] shown darkest and brightest; from 0 to the largest reflected radiosity unless given");
    parser.add_flag("--false-colour", options.look.false_colour, "Cividis over the range in place of true colour");
    parser
        .add_option_function<std::string>(
            "--background",
            [&](const std::string &text) { options.look.theme = text == "light" ? Theme::light : Theme::dark; },
            "dark (default) or light")
        ->check(CLI::IsMember({"dark", "light"}));
}

} // namespace penumbra
