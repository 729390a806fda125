#include "commands/read_script.h"

#include "action.h"
#include "commands/command.h"
#include "commands/look_options.h"
#include "commands/script_words.h"
#include "commands/solving_options.h"
#include "core/error.h"
#include "core/read_text.h"
#include "pane_verbs.h"
#include "restore.h"
#include "split_verbs.h"
#include "verbs.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

namespace penumbra {

namespace {

constexpr std::size_t longest_script = 1 << 20; // bytes

/// Options as on a command line, from a line of text; `add` adds them to a parser.
void parse(const std::string &text, const std::function<void(CLI::App &)> &add) {
    CLI::App parser;
    parser.set_help_flag();
    add(parser);
    try {
        parser.parse(text);
    } catch (const CLI::ParseError &e) {
        throw BadInput(e.what());
    }
}

SolvingOptions solving_from(const std::string &text, const Options &now) {
    SolvingOptions solving;
    solving.options = now;
    parse(text, [&](CLI::App &parser) { add_solving_options(parser, solving); });
    return solving;
}

LookOptions look_from(const std::string &text, const Look &now) {
    LookOptions look;
    look.look = now;
    parse(text, [&](CLI::App &parser) { add_look_options(parser, look); });
    return look;
}

Act set(const std::string &text) {
    solving_from(text, {});
    return [text](AppState &state) {
        const Options options = solving_from(text, state.options).options;
        if (options != state.options) {
            state.asked_tolerance = options.tolerance.value_or(state.asked_tolerance);
            start_again(state, options);
        }
        return true;
    };
}

/// The surface of that number or name; -1 for `all`.
int source_from(const std::string &text, const Scene &scene) {
    if (text == "all")
        return -1;
    for (int s = 0; s < scene.n_surfaces(); ++s)
        if (text == std::to_string(s) || text == scene.surface(SurfaceId(s)).name)
            return s;
    throw BadInput("--curve-source " + text + ": the scene has no surface of that name or number");
}

void look_at(AppState &state, const Camera &camera) {
    state.camera_of(state.panes().active) = camera;
    state.camera_is_set = state.camera_moved = true;
}

/// Ranges that are given are kept; others follow what is shown, as they did.
void show_now(AppState &state, LookOptions options, const Look &before) {
    if (options.look.range)
        state.chosen_range = options.look.range;
    else
        options.look.range = before.range;
    if (options.look.error_range)
        state.truth.range_locked = true;
    else if (options.look.error == before.error)
        options.look.error_range = before.error_range;
    else
        state.truth.range_locked = false;
    if (!options.curve_source.empty())
        options.look.curve_filter.source = source_from(options.curve_source, *state.scene);
    state.look = options.look;
    state.look.spotlight = {};
    if (state.look.shading == Shading::error)
        state.truth.halted = false;
    if (options.look.spotlight.curve >= 0)
        state.pinned_curve = options.look.spotlight.curve;
    if (options.view)
        look_at(state, camera_from(*options.view, *state.scene));
    if (options.camera)
        look_at(state, *options.camera);
    if (options.keyhole)
        state.keyhole_to_open = options.keyhole;
    if (options.profile)
        state.profile_to_open = options.profile;
    find_what_was_restored(state, state.active_strategy());
}

Act show(const std::string &text) {
    look_from(text, {});
    return [text](AppState &state) {
        if (!state.scene)
            throw BadInput("there is no scene to show");
        Look bare = state.look;
        bare.range.reset();
        bare.error_range.reset();
        show_now(state, look_from(text, bare), state.look);
        return true;
    };
}

Act go(const Words &words) {
    const Place place = words[1] == "end" ? Place{far_ahead} : place_from(words, 1);
    return [=](AppState &state) {
        if (state.position != place.position || state.split || state.linking) {
            go_to(state, place.position);
            return !place.split && !place.linking;
        }
        if (place.split)
            show_splits(state, *place.split);
        else if (place.linking)
            show_linkings(state, *place.linking);
        return true;
    };
}

Act panes(const Words &words) {
    std::vector<Strategy> chosen;
    const std::optional<Layout> named = layout_from_name(words.back());
    if (named && (!share_a_place(*named) || words.size() != 4))
        throw BadInput(in_quotes(words.back()) + " is no way to compare two strategies; there are wipe, flip and difference");
    for (std::size_t i = 1; i < words.size() - named.has_value(); ++i) {
        const auto found = std::ranges::find(all_strategies, words[i], [](Strategy s) { return std::string_view(letter(s)); });
        if (found == std::end(all_strategies))
            throw BadInput(in_quotes(words[i]) + " is no strategy; there are a, b, c and d");
        chosen.push_back(*found);
    }
    if (chosen.size() == 3 || chosen.size() > 4)
        throw BadInput("panes are one, two or four");
    return [=](AppState &state) {
        set_layout(state, named.value_or(layout_of(chosen.size())));
        std::ranges::copy(chosen, state.panes().strategies.begin());
        return true;
    };
}

Act picture(const std::string &name, const std::filesystem::path &folder, PictureRequest kind) {
    const std::filesystem::path file = folder / name;
    if (file.extension() != ".png")
        throw BadInput(in_quotes(name) + " does not end in .png");
    return [file, kind](AppState &state) {
        state.picture_request = kind;
        state.picture_file = file.string();
        return true;
    };
}

Act wait(std::string_view word, double pace) {
    double seconds = 0;
    if (!number_from(word, seconds) || !(seconds >= 0) || !std::isfinite(seconds))
        throw BadInput(in_quotes(word) + " is no number of seconds");
    auto until = std::make_shared<std::optional<Clock::time_point>>();
    return [=](AppState &) {
        if (!*until)
            *until = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(pace * seconds));
        const bool over = Clock::now() >= **until;
        if (over)
            until->reset();
        return over;
    };
}

Act action(const Words &words) {
    const Action *found = find_action(words[0]);
    if (!found)
        throw BadInput(in_quotes(words[0]) + " is no action and no word of scripts");
    auto left = std::make_shared<int>(0);
    const int times = words.size() > 1 ? whole(words[1], 1) : 1;
    return [=](AppState &state) {
        if (*left == 0)
            *left = times;
        if (!is_enabled(*found, state))
            throw BadInput("'" + std::string(found->title) + "' cannot be done now");
        run(*found, state);
        return --*left == 0;
    };
}

struct Form {
    std::string_view word;
    std::size_t least = 0, most = 0; ///< words after it
};
constexpr std::size_t any = 1000;
constexpr Form forms[] = {{"open", 1, any}, {"go", 1, 4},   {"panes", 1, any}, {"set", 1, any}, {"show", 1, any},
                          {"say", 0, any},  {"wait", 1, 1}, {"picture", 1, any}, {"window", 1, any}};

Act act_from(const std::string &text, const std::filesystem::path &pictures, double pace) {
    const Words words = words_of(text);
    if (auto act = act_of_words(words))
        return *act;
    const std::string_view first = words[0];
    const auto form = std::ranges::find(forms, first, &Form::word);
    const std::size_t n = words.size() - 1, most = form == std::end(forms) ? 1 : form->most;
    if (n > most || (form != std::end(forms) && n < form->least))
        throw BadInput(in_quotes(text) + (n > most ? " has words too many" : " is not complete"));
    const std::string rest = n == 0 ? std::string() : text.substr(static_cast<std::size_t>(words[1].data() - text.data()));
    if (first == "open")
        return [rest](AppState &state) {
            state.open_request = rest;
            return true;
        };
    if (first == "go")
        return go(words);
    if (first == "panes")
        return panes(words);
    if (first == "set")
        return set(rest);
    if (first == "show")
        return show(rest);
    if (first == "wait")
        return wait(words[1], pace);
    if (first == "picture")
        return picture(rest, pictures, PictureRequest::panes);
    if (first == "window")
        return picture(rest, pictures, PictureRequest::window);
    if (first == "say")
        return [rest](AppState &state) {
            state.caption = rest;
            return true;
        };
    return action(words);
}

} // namespace

Script read_script(const std::filesystem::path &file, const std::filesystem::path &pictures, double pace) {
    Script script{file.string(), {}};
    for (const TextLine &line : lines_of(read_text(file, longest_script)))
        try {
            script.cues.push_back({line.number, line.text, act_from(line.text, pictures, pace)});
        } catch (const BadInput &e) {
            throw BadInput(script.file + ":" + std::to_string(line.number) + ": " + e.what());
        }
    return script;
}

} // namespace penumbra
