#include "commands/look_options.h"

#include "core/read_text.h"
#include "scene/obj_header.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
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
    constexpr int least = 64, most = 16384;
    if (!width || !height || *width < least || *height < least || *width > most || *height > most)
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

/// Sets those flags that the list names.
template <std::size_t n>
void set_flags(const char *option, const std::string &text, const std::array<std::string_view, n> &names,
               std::array<bool, n> &flags) {
    flags.fill(false);
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        const auto found = std::ranges::find(names, std::string_view(text).substr(from, comma - from));
        if (found == names.end()) {
            std::string known;
            for (const std::string_view name : names)
                known.append(known.empty() ? "" : ", ").append(name);
            refuse(option, text, ("a list of " + known + " with commas between").c_str());
        }
        flags[static_cast<std::size_t>(found - names.begin())] = true;
        from = comma + 1;
    }
}

void set_keyhole(LookOptions &options, const std::string &text) {
    const auto words = words_of(text);
    Vec3 point;
    bool good = words.size() == 3;
    for (std::size_t i = 0; good && i < 3; ++i)
        good = number_from(words[i], point[static_cast<Eigen::Index>(i)]) &&
               std::isfinite(point[static_cast<Eigen::Index>(i)]);
    if (!good)
        refuse("--keyhole", text, "\"x y z\", a point on a surface");
    options.keyhole = point;
}

void add_curve_options(CLI::App &parser, LookOptions &options) {
    constexpr std::array<std::string_view, 5> kinds{"VE", "EV", "EEE", "plane", "contact"};
    constexpr std::array<std::string_view, 3> orders{"0", "1", "2"};
    CurveFilter &filter = options.look.curve_filter;
    parser.add_option_function<std::string>(
        "--curve-kinds",
        [=, &filter](const std::string &text) { set_flags("--curve-kinds", text, kinds, filter.kinds); },
        "Draws these curves alone: of VE, EV, EEE, plane, contact, with commas between");
    parser.add_option_function<std::string>(
        "--curve-orders",
        [=, &filter](const std::string &text) { set_flags("--curve-orders", text, orders, filter.orders); },
        "Draws curves of these orders alone: of 0, 1, 2, with commas between");
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
}

void set_range(LookOptions &options, const std::string &text) {
    const std::size_t colon = text.find(':');
    const auto low = number<double>(std::string_view(text).substr(0, colon));
    const auto high = colon == text.npos ? std::nullopt : number<double>(std::string_view(text).substr(colon + 1));
    if (!low || !high || !std::isfinite(*low) || !std::isfinite(*high) || !(*low < *high))
        refuse("--range", text, "LOW:HIGH in W/m\u00b2 with LOW below HIGH, as 0:12.5");
    options.look.range = Range{*low, *high};
}

} // namespace

void add_look_options(CLI::App &parser, LookOptions &options) {
    parser.add_option_function<std::string>(
        "--size", [&](const std::string &text) { set_size(options, text); }, "WIDTHxHEIGHT in pixels [1280x960]");
    parser.add_option_function<std::string>(
        "--layers", [&](const std::string &text) { set_layers(options, text); },
        "Of mesh, curves, links, with commas between, or none [mesh,curves]");
    add_curve_options(parser, options);
    parser
        .add_option_function<std::string>(
            "--shading",
            [&](const std::string &text) {
                if (text == "error")
                    throw CLI::ValidationError("--shading", "error is still to come; use polynomial, flat or linear");
                options.look.shading = *shading_from_name(text);
            },
            "polynomial (default: the solution itself), flat or linear; error is still to come")
        ->check(CLI::IsMember({"polynomial", "flat", "linear", "error"}))
        ->trigger_on_parse();
    parser.add_option_function<std::string>(
        "--view",
        [&](const std::string &text) {
            options.view = view_from(text);
            if (!options.view)
                refuse("--view", text, "\"ex ey ez tx ty tz fov\": eye, target, and the vertical angle in degrees");
        },
        "\"ex ey ez tx ty tz fov\": eye, target, vertical angle [degrees]; the scene's own unless given");
    parser.add_option("--exposure", options.look.exposure_ev, "EV: radiosity is shown 2^EV times as bright")
        ->check(CLI::Range(-40.0, 40.0))
        ->capture_default_str();
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
