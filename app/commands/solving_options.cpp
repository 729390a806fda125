#include "commands/solving_options.h"

#include "commands/terminal.h"
#include "core/read_text.h"
#include "scene/bundled.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <vector>

namespace penumbra {

namespace {

std::string effect_names() {
    std::string all;
    for (const Effect effect : all_effects)
        all += (all.empty() ? "" : ", ") + std::string(name(effect));
    return all + " (or discontinuities, its four parts)";
}

/// NAME=auto|on|off, any number of them; the last of a name holds.
void set_effects(const std::vector<std::string> &all, EffectSwitches &switches) {
    for (const std::string &text : all) {
        const std::size_t equals = text.find('=');
        const auto effects = effects_from_name(std::string_view(text).substr(0, equals));
        const auto value = equals == text.npos ? std::nullopt : switch_from_name(std::string_view(text).substr(equals + 1));
        if (effects.empty())
            throw CLI::ValidationError("--effect", "'" + text + "' names no effect; there are " + effect_names());
        if (!value)
            throw CLI::ValidationError("--effect", "'" + text + "' sets nothing; give NAME=auto, NAME=on or NAME=off");
        for (const Effect effect : effects)
            switches[effect] = *value;
    }
}

void set_moves(const std::vector<std::string> &all, std::vector<ObjectMove> &moves) {
    moves.clear();
    for (const std::string &text : all) {
        const auto words = words_of(text);
        std::array<double, 5> n{0, 0, 0, 0, 1};
        bool good = words.size() == 4 || words.size() == 5;
        for (std::size_t i = 0; good && i < words.size(); ++i)
            good = number_from(words[i], n[i]) && std::isfinite(n[i]);
        if (!good || n[0] < 0 || n[0] != std::floor(n[0]) || n[0] > 1e9 || !(n[4] > 0))
            throw CLI::ValidationError("--move", "'" + text + "' is not \"SURFACE dx dy dz [scale]\" with a surface's number, a "
                                                              "way and a scale above 0");
        moves.push_back({static_cast<int>(n[0]), {n[1], n[2], n[3]}, n[4]});
    }
}

std::map<std::string, Strategy> strategies() {
    std::map<std::string, Strategy> all;
    for (const Strategy s : all_strategies)
        all.emplace(name(s), s);
    return all;
}

std::vector<std::string> cut_choices() {
    std::vector<std::string> all;
    for (const CutChoice c : all_cut_choices)
        all.emplace_back(name(c));
    return all;
}

std::vector<std::string> gather_orders() {
    std::vector<std::string> all;
    for (const GatherOrder o : all_gather_orders)
        all.emplace_back(name(o));
    return all;
}

} // namespace

CLI::Validator positive() {
    return {[](const std::string &text) {
                char *end = nullptr;
                const double x = std::strtod(text.c_str(), &end);
                return *end == 0 && end != text.c_str() && std::isfinite(x) && x > 0
                           ? std::string()
                           : "'" + text + "' is not a positive number";
            },
            "POSITIVE"};
}

std::optional<Vec3> SolvingOptions::up_vector() const {
    if (up.empty())
        return std::nullopt;
    return up == "x" ? Vec3::UnitX() : up == "y" ? Vec3::UnitY() : Vec3::UnitZ();
}

void add_common_options(CLI::App &parser, CommonOptions &common, const std::string &output) {
    parser.add_option("-o,--output", common.output, output);
    parser.add_flag("-q,--quiet", common.quiet, "Errors only");
    parser.add_flag("-v,--verbose", common.verbose, "A line for each iteration");
}

void add_scene_options(CLI::App &parser, SolvingOptions &solving) {
    parser.add_option("SCENE", solving.scene, "An OBJ or glTF file, or the name of a bundled scene")->required();
    add_up_option(parser, solving);
}

void add_up_option(CLI::App &parser, SolvingOptions &solving) {
    parser.add_option("--up", solving.up, "The scene's up axis: x, y or z (z for OBJ, y for glTF)")
        ->check(CLI::IsMember({"x", "y", "z"}));
    parser
        .add_option_function<std::vector<std::string>>(
            "--move", [&](const std::vector<std::string> &all) { set_moves(all, solving.moves); },
            "\"SURFACE dx dy dz [scale]\": the object of this surface (its number) elsewhere, and larger or smaller; any "
            "number of times")
        ->allow_extra_args(false);
}

void add_solving_options(CLI::App &parser, SolvingOptions &solving) {
    Options &o = solving.options;
    parser
        .add_option_function<std::string>(
            "--strategy", [&o](const std::string &text) { o.strategy = *strategy_from_name(text); },
            "uniform-constant, discontinuity-constant, uniform-wavelet or discontinuity-wavelet (default)")
        ->check(CLI::IsMember(strategies()));
    parser
        .add_option_function<std::string>(
            "--cut", [&o](const std::string &text) { o.cut = *cut_choice_from_name(text); },
            "curves (default), or best: where no curve is worth it, the straight cut that lowers the error most")
        ->check(CLI::IsMember(cut_choices()));
    parser
        .add_option_function<std::string>(
            "--basis",
            [&o](const std::string &text) {
                o.basis = text == name(BasisFamily::planar) ? BasisFamily::planar : BasisFamily::parametric;
            },
            "parametric (the paper's quads, default) or planar (convex polygons of any shape)")
        ->check(CLI::IsMember({"parametric", "planar"}));
    parser.add_option("--order", o.order, "Polynomials of degree below this in each parameter, 1 to 4")
        ->check(CLI::Range(1, 4))
        ->capture_default_str();
    auto *depth = parser.add_option("--max-depth", o.max_depth, "Halvings of both directions, 0 to 20")
                      ->check(CLI::Range(0, deepest))
                      ->capture_default_str();
    // The one said last is meant, also over a saved state that has the other. A depth limit that is said stays.
    const auto ask = [&o, depth](Options (Options::*by)(double) const, double value) {
        const int said = o.max_depth;
        o = (o.*by)(value);
        if (depth->count() > 0)
            o.max_depth = said;
    };
    parser
        .add_option_function<double>(
            "--threshold", [ask](double value) { ask(&Options::to_threshold, value); },
            "Largest misfit, as a fraction of the largest reflected radiosity")
        ->check(positive())
        ->default_str(fmt::format("{:g}", o.threshold));
    parser
        .add_option_function<double>(
            "--tolerance", [ask](double value) { ask(&Options::to_tolerance, value); },
            "Relative L2 error of the reflected radiosity asked for; thresholds are found, and no depth limit holds unless "
            "--max-depth sets one")
        ->check(positive())
        ->excludes("--threshold");
    parser.add_option("--max-iterations", o.max_iterations, "Iterations before giving up")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    parser
        .add_option_function<std::string>(
            "--coarse-correction",
            [&o](const std::string &text) { o.coarse_correction = *switch_from_name(text); },
            "auto (default: where a reflectance reaches 0.95), on or off: each step goes on with a constant on each "
            "surface, solved for directly")
        ->check(CLI::IsMember({"auto", "on", "off"}));
    parser
        .add_option_function<std::string>(
            "--gather", [&o](const std::string &text) { o.gather = *gather_order_from_name(text); },
            "In which order light is gathered: jacobi (default: from the step before), gauss-seidel (surface after "
            "surface, from what is there by then) or southwell (the surface with the most unshot light shoots first)")
        ->check(CLI::IsMember(gather_orders()));
    parser.add_option("--threads", o.threads, "Threads; 0: all cores")->check(CLI::Range(0, 4096))->capture_default_str();
    parser
        .add_option_function<std::vector<std::string>>(
            "--effect", [&o](const std::vector<std::string> &all) { set_effects(all, o.effects); },
            "What is simulated, repeatable: " + effect_names() + "; auto (default: what the scene calls for), on or off")
        ->type_name("NAME=auto|on|off")
        ->expected(1)
        ->take_all();
    parser
        .add_option("--memory-limit", solving.limits.memory_mib,
                    "MiB of resident memory, beyond which the last complete solution is written")
        ->check(positive());
    parser.add_option("--time-limit", solving.limits.seconds, "Seconds after which the last complete solution is written")
        ->check(positive());
}

void add_probe_options(CLI::App &parser, SolvingOptions &solving) {
    auto *in = parser.add_option("--probe", solving.probe, "CSV of points and normals: x,y,z,nx,ny,nz");
    auto *out = parser.add_option("--probe-output", solving.probe_output, "The same rows with r,g,b added");
    in->needs(out);
    out->needs(in);
}

Scene open_scene(const SolvingOptions &solving, const CommonOptions &common) {
    Scene scene = open_scene(solving.scene, solving.up_vector());
    if (!solving.moves.empty())
        scene = with_moves(scene, solving.moves);
    if (!common.quiet)
        say_notes(scene.notes);
    return scene;
}

} // namespace penumbra
