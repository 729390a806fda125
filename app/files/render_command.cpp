#include "files/render_command.h"

#include "discontinuity/curve.h"
#include "timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <ranges>
#include <vector>

namespace penumbra {

namespace {

/// A command under way.
struct Line {
    std::string text;

    void word(std::string_view w) { text += (text.empty() ? "" : " ") + shell_word(w); }
    /// A value that begins as an option does is held to its own by an equals sign.
    void option(const std::string &name, const std::string &value) {
        if (value.starts_with('-'))
            word(name + "=" + value);
        else
            word(name), word(value);
    }
    template <class Value>
    void number_unless(const std::string &name, const Value &value, const Value &usual) {
        if (value != usual)
            option(name, fmt::format("{}", value));
    }
    template <class Value>
    void name_unless(const std::string &option_name, const Value &value, const Value &usual) {
        if (value != usual)
            option(option_name, std::string(name(value)));
    }
    void flag(const std::string &name, bool there) {
        if (there)
            word(name);
    }
};

std::string range_text(const Range &range) { return fmt::format("{}:{}", range.low, range.high); }

template <class... Vectors>
std::string triples(const Vectors &...vectors) {
    std::string text;
    const auto add = [&](const auto &v) {
        for (int i = 0; i < 3; ++i)
            text += fmt::format("{}{}", text.empty() ? "" : " ", v[i]);
    };
    (add(vectors), ...);
    return text;
}

std::string joined(const std::vector<std::string> &words) {
    return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ","));
}

char usual_up(const std::string &file) {
    std::string end = std::filesystem::path(file).extension().string();
    std::ranges::transform(end, end.begin(), [](unsigned char c) { return std::tolower(c); });
    return end == ".gltf" || end == ".glb" ? 'y' : 'z';
}

void add_scene(Line &line, const SavedState &state) {
    line.word(state.file.empty() ? state.scene : state.file);
    if (state.up && *state.up != usual_up(state.file))
        line.option("--up", std::string(1, *state.up));
    for (const ObjectMove &move : state.moves)
        line.option("--move", fmt::format("{} {}", move.surface, triples(move.offset)) +
                                  (move.scale == 1 ? "" : fmt::format(" {}", move.scale)));
}

void add_panes(Line &line, const SavedState &state) {
    std::vector<std::string> panes;
    for (std::size_t i = 0; i < state.strategies.size(); ++i) {
        if (state.layout == Layout::flip && static_cast<int>(i) != state.active)
            continue;
        const bool as_quadratics = i < state.reconstructed.size() && state.reconstructed[i];
        panes.push_back(std::string(1, "abcd"[static_cast<int>(state.strategies[i])]) + (as_quadratics ? "q" : ""));
    }
    if (state.layout == Layout::wipe)
        line.option("--wipe", fmt::format("{}", state.wipe));
    if (state.layout == Layout::difference)
        line.option("--layout", std::string(name(Layout::difference)));
    const bool lettered = !state.picture || state.picture->lettered || panes.size() > 1 || panes[0].size() > 1;
    if (lettered)
        line.option("--panes", joined(panes));
    else
        line.name_unless("--strategy", state.strategies[0], Options().strategy);
    if (panes.size() == 2 && std::ranges::count(state.reconstructed, true) == 0)
        line.flag("--no-price", !state.picture || !state.picture->priced);
}

void add_options(Line &line, const Options &o) {
    const Options usual = o.tolerance ? Options().to_tolerance(*o.tolerance) : Options();
    if (o.tolerance)
        line.option("--tolerance", fmt::format("{}", *o.tolerance));
    else
        line.option("--threshold", fmt::format("{}", o.threshold));
    line.number_unless("--max-depth", o.max_depth, usual.max_depth);
    line.number_unless("--max-iterations", o.max_iterations, usual.max_iterations);
    line.name_unless("--basis", o.basis, usual.basis);
    line.number_unless("--order", o.order, usual.order);
    line.name_unless("--cut", o.cut, usual.cut);
    line.name_unless("--coarse-correction", o.coarse_correction, usual.coarse_correction);
    line.name_unless("--gather", o.gather, usual.gather);
    for (const Effect effect : all_effects)
        if (o.effects[effect] != Switch::automatic)
            line.option("--effect", fmt::format("{}={}", name(effect), name(o.effects[effect])));
}

std::string steps_text(int position) {
    const Phase phase = phase_of(position);
    return std::to_string(iteration_of(position)) +
           (phase == Phase::refined || phase == Phase::gathered ? " " + std::string(name(phase)) : "");
}

void add_position(Line &line, const SavedState &state) {
    if (!state.converged && !state.positions.empty()) {
        for (std::size_t i = 0; i < state.positions.size(); ++i)
            if (state.layout != Layout::flip || static_cast<int>(i) == state.active)
                line.option("--pane-steps", steps_text(state.positions[i]));
    } else if (!state.converged) {
        line.option("--steps", std::to_string(iteration_of(state.position)));
        if (const Phase phase = phase_of(state.position); phase == Phase::refined || phase == Phase::gathered)
            line.option("--phase", std::string(name(phase)));
        if (state.split)
            line.option("--split", std::to_string(*state.split));
        else if (state.linking)
            line.option("--link", std::to_string(*state.linking));
    }
    const bool usual = !state.converged;
    if (state.look.emphasise_fresh != usual)
        line.word(usual ? "--no-fresh" : "--fresh");
}

void add_curves(Line &line, const Look &look) {
    std::vector<std::string> kinds, orders;
    for (std::size_t k = 0; k < look.curve_filter.kinds.size(); ++k)
        if (look.curve_filter.kinds[k])
            kinds.emplace_back(name(static_cast<CurveKind>(k)));
    for (std::size_t k = 0; k < look.curve_filter.orders.size(); ++k)
        if (look.curve_filter.orders[k])
            orders.push_back(std::to_string(k));
    if (kinds.size() < look.curve_filter.kinds.size())
        line.option("--curve-kinds", joined(kinds));
    if (orders.size() < look.curve_filter.orders.size())
        line.option("--curve-orders", joined(orders));
    line.number_unless("--curve-source", look.curve_filter.source, -1);
    line.number_unless("--curve", look.spotlight.curve, -1);
}

void add_look(Line &line, const Look &look, bool difference) {
    const Look usual;
    std::vector<std::string> layers;
    for (const auto &[on, layer] : {std::pair(look.layers.mesh, "mesh"), std::pair(look.layers.curves, "curves"),
                                    std::pair(look.layers.links, "links")})
        if (on)
            layers.emplace_back(layer);
    if (look.layers != usual.layers)
        line.option("--layers", joined(layers));
    add_curves(line, look);
    if (difference && look.error_range)
        line.option("--error-range", range_text(*look.error_range));
    if (!difference)
        line.name_unless("--shading", look.shading, usual.shading);
    if (!difference && look.shading == Shading::error) {
        line.name_unless("--error", look.error, usual.error);
        if (look.change)
            line.option("--change", text_of(*look.change));
        if (look.error_range)
            line.option("--error-range", range_text(*look.error_range));
    }
    line.number_unless("--exposure", look.exposure_ev, usual.exposure_ev);
    if (look.range)
        line.option("--range", range_text(*look.range));
    line.flag("--false-colour", look.false_colour);
    if (look.theme == Theme::light)
        line.option("--background", "light");
    line.flag("--transparent", look.transparent);
}

/// Each range is told, or that the pane has its own.
void add_tones(Line &line, const SavedState &state) {
    const auto text = [](const std::optional<Range> &range) { return range ? range_text(*range) : "own"; };
    for (const Tone &tone : state.tones)
        line.option("--pane-exposure", fmt::format("{}", tone.exposure_ev));
    for (const Tone &tone : state.tones)
        line.option("--pane-range", text(tone.range));
    if (std::ranges::any_of(state.tones, [](const Tone &tone) { return tone.error_range.has_value(); }))
        for (const Tone &tone : state.tones)
            line.option("--pane-error-range", text(tone.error_range));
}

void add_picture(Line &line, const SavedState &state) {
    const SavedPicture usual, picture = state.picture.value_or(usual);
    if (picture.width != usual.width || picture.height != usual.height)
        line.option("--size", fmt::format("{}x{}", picture.width, picture.height));
    line.number_unless("--supersample", picture.supersample, usual.supersample);
    line.flag("--no-labels", !picture.labels);
    line.flag("--no-legend", !state.legend);
    if (state.camera)
        line.option("--camera", fmt::format("{} {}", triples(state.camera->eye, state.camera->target, state.camera->up),
                                            state.camera->fov_y));
    for (const Camera &c : state.cameras)
        line.option("--pane-camera", fmt::format("{} {}", triples(c.eye, c.target, c.up), c.fov_y));
    add_tones(line, state);
    if (state.keyhole)
        line.option("--keyhole", triples(*state.keyhole));
    if (!state.caption.empty())
        line.option("--caption", state.caption);
    if (state.profile)
        line.option("--profile", triples(state.profile->first, state.profile->second));
}

} // namespace

std::string shell_word(std::string_view text) {
    const auto safe = [](unsigned char c) {
        return std::isalnum(c) || std::string_view("_./:=,+-@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, safe))
        return std::string(text);
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string render_command(const SavedState &state) {
    Line line{"penumbra render"};
    add_scene(line, state);
    add_panes(line, state);
    add_options(line, state.options);
    add_position(line, state);
    add_look(line, state.look, state.layout == Layout::difference);
    add_picture(line, state);
    std::string stem = state.scene.empty() ? "picture" : state.scene;
    std::ranges::replace(stem, '/', '-');
    line.option("-o", (stem.starts_with('-') ? "./" : "") + stem + ".png");
    return line.text;
}

} // namespace penumbra
