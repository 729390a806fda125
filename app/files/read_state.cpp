#include "files/read_state.h"

#include "core/error.h"
#include "core/read_text.h"
#include "discontinuity/curve.h"
#include "scene/json_value.h"
#include "timeline.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace penumbra {

namespace {

constexpr std::size_t longest_line = 4096, most_bookmarks = 100;
constexpr int most_iterations = 1'000'000, most_surfaces = 1'000'000, most_curves = 100'000'000,
              most_events = 10'000'000;
constexpr std::size_t most_moves = 1000;
constexpr double farthest = 1e15; ///< of coordinates; the largest scene is far smaller

double number_in(const JsonValue &value, double low, double high) {
    const double x = value.number();
    if (!(x >= low && x <= high))
        value.fail(fmt::format("is {:g}; give a number from {:g} to {:g}", x, low, high));
    return x;
}

double positive_number(const JsonValue &value) {
    const double x = number_in(value, 0, 1e6);
    if (!(x > 0))
        value.fail("is 0; give a positive number");
    return x;
}

template <class Vector>
Vector triple(const JsonValue &value) {
    if (const std::size_t n = value.size(); n != 3)
        value.fail(fmt::format("has {} numbers; give x, y and z", n));
    return Vector(number_in(value.at(0), -farthest, farthest), number_in(value.at(1), -farthest, farthest),
                  number_in(value.at(2), -farthest, farthest));
}

/// What the text names; `find` gives nothing for what it does not know.
template <class Find>
auto named(const JsonValue &value, const Find &find, const char *choices) {
    const std::string text = value.text();
    const auto found = find(text);
    if (!found)
        value.fail("is " + in_quotes(text) + "; give " + choices);
    return *found;
}

void read_flag(const JsonValue &object, const char *key, bool &flag) {
    if (const auto value = object.known(key))
        flag = value->boolean();
}

void read_whole(const JsonValue &object, const char *key, int least, int most, int &number) {
    if (const auto value = object.known(key))
        number = static_cast<int>(value->integer(least, most));
}

constexpr const char *strategy_choices =
    "uniform-constant, discontinuity-constant, uniform-wavelet or discontinuity-wavelet";

Options read_options(const JsonValue &json) {
    Options o;
    if (const auto threshold = json.known("threshold"))
        o.threshold = positive_number(*threshold);
    if (const auto tolerance = json.known("tolerance"))
        o.tolerance = positive_number(*tolerance);
    if (const auto basis = json.known("basis"))
        o.basis = named(*basis, basis_family_from_name, "parametric or planar");
    if (const auto cut = json.known("cut"))
        o.cut = named(*cut, cut_choice_from_name, "curves or best");
    if (const auto correction = json.known("coarse_correction"))
        o.coarse_correction = named(*correction, switch_from_name, "auto, on or off");
    if (const auto gather = json.known("gather"))
        o.gather = named(*gather, gather_order_from_name, "jacobi, gauss-seidel or southwell");
    if (const auto effects = json.known("effects"))
        for (const Effect effect : all_effects)
            if (const auto value = effects->known(std::string(name(effect)).c_str()))
                o.effects[effect] = named(*value, switch_from_name, "auto, on or off");
    read_whole(json, "order", 1, 4, o.order);
    read_whole(json, "max_depth", 0, 20, o.max_depth);
    read_whole(json, "max_iterations", 1, most_iterations, o.max_iterations);
    return o;
}

ObjectMove read_move(const JsonValue &json) {
    ObjectMove move;
    read_whole(json, "surface", 0, most_surfaces, move.surface);
    if (const auto offset = json.known("offset"))
        move.offset = triple<Vec3>(*offset);
    if (const auto scale = json.known("scale"))
        move.scale = positive_number(*scale);
    return move;
}

void read_strategies(const JsonValue &list, SavedState &state) {
    const std::size_t n = list.size();
    if (n < 1 || n > most_panes)
        list.fail(fmt::format("has {} strategies; give 1 to {}", n, most_panes));
    state.strategies.clear();
    for (std::size_t i = 0; i < n; ++i)
        state.strategies.push_back(named(list.at(i), strategy_from_name, strategy_choices));
}

/// How many stand side by side is told by the strategies; the other layouts compare two.
void read_layout(const JsonValue &root, SavedState &state) {
    const std::size_t n = state.strategies.size();
    if (const auto layout = root.known("layout")) {
        const Layout given = named(*layout, layout_from_name, "single, two, four, wipe, flip or difference");
        if (share_a_place(given) && n != 2)
            layout->fail(fmt::format("is {} with {} {}; give two", in_quotes(name(given)), n, n == 1 ? "strategy" : "strategies"));
        if (share_a_place(given))
            state.layout = given;
    }
    if (const auto wipe = root.known("wipe"))
        state.wipe = number_in(*wipe, 0, 1);
}

void read_reconstructed(const JsonValue &list, SavedState &state) {
    if (const std::size_t n = list.size(); n > state.strategies.size())
        list.fail(fmt::format("has {} flags; give one for each of the {} strategies", n, state.strategies.size()));
    state.reconstructed.clear();
    for (std::size_t i = 0; i < list.size(); ++i) {
        state.reconstructed.push_back(list.at(i).boolean());
        if (state.reconstructed.back() && !is_constant(state.strategies[i]))
            list.at(i).fail("is true for a strategy without constants");
    }
}

/// States before `position` have the iteration and the phase alone.
int read_position(const JsonValue &root) {
    int position = 0, iteration = 0;
    if (root.known("position")) {
        read_whole(root, "position", 0, phases_per_iteration * most_iterations, position);
        return position;
    }
    read_whole(root, "iteration", 0, most_iterations, iteration);
    const auto phase = root.known("phase");
    if (iteration == 0 || !phase)
        return phases_per_iteration * iteration;
    const auto phase_from_name = [](std::string_view text) -> std::optional<int> {
        for (int p = 0; p <= phases_per_iteration; ++p)
            if (name(phase_of(p)) == text)
                return p;
        return std::nullopt;
    };
    const int in_iteration = named(*phase, phase_from_name, "start, refine, gather or push-pull");
    return in_iteration == 0 ? 0 : phases_per_iteration * (iteration - 1) + in_iteration;
}

Camera read_camera(const JsonValue &json) {
    Camera camera;
    camera.eye = triple<glm::dvec3>(json["eye"]);
    camera.target = triple<glm::dvec3>(json["target"]);
    if (const auto up = json.known("up"))
        camera.up = triple<glm::dvec3>(*up);
    if (const auto fov = json.known("fov"))
        camera.fov_y = number_in(*fov, 0.01, 175);
    const glm::dvec3 forward = camera.target - camera.eye;
    const double length = glm::length(forward), up = glm::length(camera.up);
    const double near = 1e-12 * std::max({1e-12, glm::length(camera.eye), glm::length(camera.target)});
    if (!(length > near))
        json.fail("has its eye in its target; move one of them");
    if (!(up > 0))
        json.fail("has an up of length 0; give a direction");
    if (std::abs(up - 1) > 1e-9)
        camera.up /= up;
    if (!(glm::length(glm::cross(forward / length, camera.up)) > 1e-9))
        json.fail("looks along its up; give another up, or move the eye");
    return camera;
}

/// How many there are of what panes have of their own: none, or one for each; of views and exposures only side by side.
std::size_t number_by_pane(const JsonValue &list, const SavedState &state, const char *what, bool side_by_side = true) {
    const std::size_t n = list.size(), n_panes = state.strategies.size();
    if (n > 0 && state.layout && side_by_side)
        list.fail(fmt::format("has {} {}, and layout {} has one place; leave them out", n, what, in_quotes(name(*state.layout))));
    if (n > 0 && n != n_panes)
        list.fail(fmt::format("has {} {}; give one for each of the {} strategies, or none", n, what, n_panes));
    return n;
}

void read_cameras(const JsonValue &list, SavedState &state) {
    const std::size_t n = number_by_pane(list, state, "views");
    for (std::size_t i = 0; i < n; ++i)
        state.cameras.push_back(read_camera(list.at(i)));
}

void read_curves(const JsonValue &json, Look &look) {
    if (const auto kinds = json.known("kinds")) {
        look.curve_filter.kinds.fill(false);
        const auto kind_from_name = [&](std::string_view text) -> std::optional<std::size_t> {
            for (std::size_t k = 0; k < look.curve_filter.kinds.size(); ++k)
                if (name(static_cast<CurveKind>(k)) == text)
                    return k;
            return std::nullopt;
        };
        for (std::size_t i = 0; i < kinds->size(); ++i)
            look.curve_filter.kinds[named(kinds->at(i), kind_from_name, "VE, EV, EEE, plane or contact")] = true;
    }
    if (const auto orders = json.known("orders")) {
        look.curve_filter.orders.fill(false);
        for (std::size_t i = 0; i < orders->size(); ++i)
            look.curve_filter.orders[static_cast<std::size_t>(orders->at(i).integer(0, 2))] = true;
    }
    read_whole(json, "source", 0, most_surfaces, look.curve_filter.source);
    read_whole(json, "shown", 0, most_curves, look.spotlight.curve);
}

Range read_range(const JsonValue &json) {
    if (const std::size_t n = json.size(); n != 2)
        json.fail(fmt::format("has {} numbers; give the low and the high end", n));
    const Range range{number_in(json.at(0), -farthest, farthest), number_in(json.at(1), -farthest, farthest)};
    if (!(range.low < range.high))
        json.fail(fmt::format("is {:g} to {:g}; give the low end first", range.low, range.high));
    return range;
}

Range read_error_range(const JsonValue &json, ErrorKind kind) {
    const Range range = read_range(json);
    if (kind != ErrorKind::signed_error && !(range.low > 0))
        json.fail("has a low end that is not above 0, as the kind asks for");
    return range;
}

/// After the look: what kind of errors there are.
void read_tones(const JsonValue &list, SavedState &state) {
    const std::size_t n = number_by_pane(list, state, "exposures");
    for (std::size_t i = 0; i < n; ++i) {
        const JsonValue json = list.at(i);
        Tone &tone = state.tones.emplace_back();
        if (const auto exposure = json.known("exposure"))
            tone.exposure_ev = number_in(*exposure, -40, 40);
        if (const auto range = json.known("range"))
            tone.range = read_range(*range);
        if (const auto range = json.known("error_range"))
            tone.error_range = read_error_range(*range, state.look.error);
        read_flag(json, "range_chosen", tone.range_chosen);
        read_flag(json, "error_range_locked", tone.error_range_locked);
        tone.range_chosen &= tone.range.has_value();
        tone.error_range_locked &= tone.error_range.has_value();
    }
}

void read_positions(const JsonValue &list, SavedState &state) {
    const std::size_t n = number_by_pane(list, state, "steps", false);
    for (std::size_t i = 0; i < n; ++i)
        state.positions.push_back(static_cast<int>(list.at(i).integer(0, phases_per_iteration * most_iterations)));
}

void read_error(const JsonValue &json, SavedState &state) {
    Look &look = state.look;
    if (const auto kind = json.known("kind"))
        look.error = named(*kind, error_kind_from_name, "signed, relative, patch or estimate");
    if (const auto range = json.known("range"))
        look.error_range = read_error_range(*range, look.error);
    read_flag(json, "locked", state.error_range_locked);
    if (const auto change = json.known("change"))
        look.change = named(*change, effect_change_from, "an effect's name with =on or =off");
}

void read_look(const JsonValue &root, SavedState &state) {
    Look &look = state.look;
    if (const auto layers = root.known("layers")) {
        read_flag(*layers, "mesh", look.layers.mesh);
        read_flag(*layers, "curves", look.layers.curves);
        read_flag(*layers, "links", look.layers.links);
        read_flag(*layers, "fresh", look.emphasise_fresh);
        read_flag(*layers, "legend", state.legend);
    }
    if (const auto curves = root.known("curves"))
        read_curves(*curves, look);
    if (const auto shading = root.known("shading"))
        look.shading = named(*shading, shading_from_name, "polynomial, flat, linear or error");
    if (const auto error = root.known("error"))
        read_error(*error, state);
    read_flag(root, "false_colour", look.false_colour);
    if (const auto exposure = root.known("exposure"))
        look.exposure_ev = number_in(*exposure, -40, 40);
    if (const auto range = root.known("range"))
        look.range = read_range(*range);
    read_flag(root, "range_chosen", state.range_chosen);
    if (const auto background = root.known("background")) {
        const auto theme = [](std::string_view text) {
            return text == "dark"    ? std::optional(Theme::dark)
                   : text == "light" ? std::optional(Theme::light)
                                     : std::nullopt;
        };
        look.theme = named(*background, theme, "dark or light");
    }
}

SavedPicture read_picture(const JsonValue &json, Look &look) {
    SavedPicture picture;
    read_whole(json, "width", smallest_picture, largest_picture, picture.width);
    read_whole(json, "height", smallest_picture, largest_picture, picture.height);
    read_flag(json, "lettered", picture.lettered);
    read_flag(json, "priced", picture.priced);
    read_flag(json, "labels", picture.labels);
    read_whole(json, "supersample", 1, most_supersampling, picture.supersample);
    read_flag(json, "transparent", look.transparent);
    return picture;
}

/// Of one printable line, as messages quote it.
std::string read_line(const JsonValue &value, const char *remedy) {
    std::string text = value.text(longest_line);
    if (std::ranges::any_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
        value.fail(std::string("has control characters; ") + remedy);
    return text;
}

std::string read_name(const JsonValue &value) { return read_line(value, "rename the scene's file"); }

void read_scene(const JsonValue &root, SavedState &state) {
    const JsonValue scene = root["scene"];
    state.scene = read_name(scene);
    if (const auto file = root.known("file"))
        state.file = read_name(*file);
    if (state.scene.empty() && state.file.empty())
        scene.fail("is empty; name a bundled scene, or give the scene's file");
    if (const auto up = root.known("up")) {
        const auto axis = [](std::string_view text) {
            return text == "x" || text == "y" || text == "z" ? std::optional(text[0]) : std::nullopt;
        };
        state.up = named(*up, axis, "x, y or z");
    }
}

/// What is shown, and how.
void read_view(const JsonValue &root, SavedState &state) {
    read_scene(root, state);
    if (const auto moves = root.known("moves")) {
        if (const std::size_t n = moves->size(); n > most_moves)
            moves->fail(fmt::format("has {} objects; at most {} are moved", n, most_moves));
        for (std::size_t i = 0; i < moves->size(); ++i)
            state.moves.push_back(read_move(moves->at(i)));
    }
    if (const auto options = root.known("options"))
        state.options = read_options(*options);
    if (const auto strategies = root.known("strategies"))
        read_strategies(*strategies, state);
    read_layout(root, state);
    if (const auto reconstructed = root.known("reconstructed"))
        read_reconstructed(*reconstructed, state);
    read_whole(root, "active", 0, static_cast<int>(state.strategies.size()) - 1, state.active);
    state.options.strategy = state.strategies[static_cast<std::size_t>(state.active)];
    state.position = read_position(root);
    if (const auto positions = root.known("positions"))
        read_positions(*positions, state);
    if (const auto split = root.known("split"))
        state.split = static_cast<int>(split->integer(1, most_events));
    if (const auto linking = root.known("linking"))
        state.linking = static_cast<int>(linking->integer(1, most_events));
    read_flag(root, "converged", state.converged);
    if (const auto camera = root.known("camera"))
        state.camera = read_camera(*camera);
    if (const auto cameras = root.known("cameras"))
        read_cameras(*cameras, state);
    read_look(root, state);
    if (const auto tones = root.known("tones"))
        read_tones(*tones, state);
    if (const auto keyhole = root.known("keyhole"))
        state.keyhole = triple<Vec3>(*keyhole);
    if (const auto profile = root.known("profile")) {
        if (const std::size_t n = profile->size(); n != 2)
            profile->fail(fmt::format("has {} points; give two", n));
        state.profile = std::pair(triple<Vec3>(profile->at(0)), triple<Vec3>(profile->at(1)));
    }
    if (const auto picture = root.known("picture"))
        state.picture = read_picture(*picture, state.look);
    if (const auto caption = root.known("caption"))
        state.caption = read_line(*caption, "take them out");
}

} // namespace

SavedState read_state(const std::string &file, std::string_view text) {
    if (text.size() > largest_state)
        throw BadInput(
            fmt::format("{}: is longer than a saved state's limit of {} KiB; open a file that Penumbra wrote", file,
                        largest_state >> 10));
    const nlohmann::json json = parse_json(file, text, {.bytes = largest_state, .depth = 16, .values = 20'000});
    const JsonValue root(json, file);
    SavedState state;
    int format = state_format;
    read_whole(root, "format", 1, 1'000'000, format);
    if (format > state_format) {
        const auto by = root.known("written_by");
        state.notes.push_back(fmt::format("{}: was written by a later version ({}, format {}); what this one does not "
                                          "know is passed over",
                                          file, by ? in_quotes(by->text()) : "not named", format));
    }
    read_view(root, state);
    if (const auto bookmarks = root.known("bookmarks")) {
        if (const std::size_t n = bookmarks->size(); n > most_bookmarks)
            bookmarks->fail(fmt::format("has {} views; at most {} are kept", n, most_bookmarks));
        for (std::size_t i = 0; i < bookmarks->size(); ++i)
            read_view(bookmarks->at(i), state.bookmarks.emplace_back());
    }
    return state;
}

} // namespace penumbra
