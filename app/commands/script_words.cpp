#include "commands/script_words.h"

#include "bookmark_verbs.h"
#include "core/error.h"
#include "core/read_text.h"
#include "element_verbs.h"
#include "files/settings.h"
#include "microscope_verbs.h"
#include "move_verbs.h"
#include "timeline.h"
#include "verbs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace penumbra {

namespace {

double real(std::string_view word) {
    double value = 0;
    if (!number_from(word, value) || !std::isfinite(value))
        throw BadInput(in_quotes(word) + " is no number");
    return value;
}
Vec3 point(const Words &words, std::size_t from) { return {real(words[from]), real(words[from + 1]), real(words[from + 2])}; }
int whole_or_none(std::string_view word) { return word == "none" ? -1 : whole(word, 0); }

/// An act that is done at once.
Act at_once(std::function<void(AppState &)> act) {
    return [act = std::move(act)](AppState &state) {
        act(state);
        return true;
    };
}

void need_surface(const AppState &state, int surface) {
    if (!state.scene || surface >= state.scene->n_surfaces())
        throw BadInput("the scene has no surface " + std::to_string(surface));
}

Act move(const Words &words) {
    const ObjectMove wanted{whole(words[1], 0), point(words, 2), words.size() > 5 ? real(words[5]) : 1};
    if (!(wanted.scale > 0))
        throw BadInput(in_quotes(words[5]) + " is no scale above 0");
    return at_once([=](AppState &state) {
        need_surface(state, wanted.surface);
        const int in_hand = state.objects.chosen;
        choose_object(state, wanted.surface);
        ObjectMove now = wanted;
        now.surface = state.objects.chosen;
        move_object(state, now);
        state.objects.chosen = in_hand;
    });
}

Act object(const Words &words) {
    return at_once([surface = whole_or_none(words[1])](AppState &state) {
        need_surface(state, surface);
        choose_object(state, surface);
    });
}

Act pick(const Words &words) {
    return at_once([at = SurfacePoint{whole(words[1], 0), point(words, 2)}](AppState &state) {
        need_surface(state, at.surface);
        if (state.inspector == Inspector::element)
            pick_element(state, at);
        else if (state.inspector == Inspector::filters)
            pick_split(state, at);
        else
            throw BadInput("nothing is picked before view.inspector or view.filters is open");
    });
}

Act xray(const Words &words) {
    const int surface = whole_or_none(words[1]);
    const bool worst = words.size() > 2 && words[2] == "worst";
    if (words.size() > 2 && !worst && words[2] != "centre")
        throw BadInput(in_quotes(words[2]) + " is no line of an X-ray; there are centre and worst");
    return at_once([=](AppState &state) {
        if (state.element.source.value_or(-1) != surface)
            pick_source(state, surface < 0 ? *state.element.source : surface);
        set_xray_line(state, worst ? XrayLine::worst : XrayLine::centre);
    });
}

Act filters(const Words &words) {
    return at_once([outward = whole(words[1], 0), piece = whole(words[2], 0)](AppState &state) {
        Microscope &m = state.microscope;
        update_microscope(state);
        step_outward(state, outward - m.outward);
        update_microscope(state);
        if (m.shown)
            m.piece = std::clamp(piece, 0, static_cast<int>(m.shown->pieces.size()) - 1);
    });
}

Act pivot(const Words &words) {
    return at_once([p = point(words, 1)](AppState &state) { state.pivot = glm::dvec3(p.x(), p.y(), p.z()); });
}

Act wipe(const Words &words) {
    const double share = real(words[1]);
    if (!(share >= 0 && share <= 1))
        throw BadInput(in_quotes(words[1]) + " is no place of a divider; there are 0 to 1");
    return at_once([share](AppState &state) { state.wipe = share; });
}

Act play(const Words &words) {
    const int until = words.size() > 1 ? place_from(words, 1).position : far_ahead;
    return at_once([until](AppState &state) {
        go_to(state, state.position); // what was cancelled is taken up again
        if (state.position >= until) {
            go_to(state, until);
            return;
        }
        state.playing = true;
        state.play_until = until;
    });
}

Act speed(const Words &words) {
    return at_once([value = real(words[1])](AppState &state) { set_speed(state, value); });
}

Act cost(const Words &words) {
    const auto measure = cost_measure_from_name(words[1]);
    if (!measure)
        throw BadInput(in_quotes(words[1]) + " is no measure of cost");
    return at_once([=](AppState &state) { state.cost_measure = *measure; });
}

Act pictures(const Words &words) {
    PictureSettings settings;
    const auto sizes = {PictureSize::panes, PictureSize::full_hd, PictureSize::ultra_hd, PictureSize::eight_k};
    const auto named = [](PictureSize size) {
        const PixelSize pixels = pixels_of(size);
        return pixels.width == 0 ? std::string("panes") : fmt::format("{}x{}", pixels.width, pixels.height);
    };
    const auto found = std::ranges::find(sizes, words[1], named);
    if (found == sizes.end())
        throw BadInput(in_quotes(words[1]) + " is no size of pictures; there are panes, 1920x1080, 3840x2160, 7680x4320");
    settings.size = *found;
    settings.supersample = std::min(whole(words[2], 1), 4);
    for (std::size_t i = 3; i < words.size(); ++i) {
        if (words[i] != "transparent" && words[i] != "no-labels")
            throw BadInput(in_quotes(words[i]) + " is nothing of pictures; there are transparent and no-labels");
        (words[i] == "transparent" ? settings.transparent : settings.labels) = words[i] == "transparent";
    }
    return at_once([settings](AppState &state) { state.pictures.settings = settings; });
}

/// The bookmark of that number, counted from 1.
int bookmark_of(const AppState &state, int number) {
    if (number > static_cast<int>(state.bookmarks.size()))
        throw BadInput("there is no bookmark " + std::to_string(number));
    return number - 1;
}

Act bookmark(const Words &words) {
    return at_once([n = whole(words[1], 1)](AppState &state) { go_to_bookmark(state, bookmark_of(state, n)); });
}
Act forget(const Words &words) {
    return at_once([n = whole(words[1], 1)](AppState &state) { remove_bookmark(state, bookmark_of(state, n)); });
}
Act caption(const Words &words) {
    const std::string text = words.size() < 3 ? std::string() : std::string(words[2].data(), words.back().data() + words.back().size());
    return at_once([n = whole(words[1], 1), text](AppState &state) {
        const int number = bookmark_of(state, n);
        state.bookmarks[static_cast<std::size_t>(number)].caption = text;
        if (number == state.bookmark)
            state.caption = text;
    });
}

Act unpin(const Words &) {
    return at_once([](AppState &state) { state.pinned_curve.reset(); });
}

struct Form {
    std::string_view word;
    std::size_t least, most; ///< words after it
    Act (*act)(const Words &);
};
constexpr std::size_t any = 1000;
constexpr Form forms[] = {{"move", 4, 5, move},       {"object", 1, 1, object},     {"pick", 4, 4, pick},
                          {"xray", 1, 2, xray},       {"filters", 2, 2, filters},   {"pivot", 3, 3, pivot},
                          {"unpin", 0, 0, unpin},     {"play", 0, 2, play},         {"speed", 1, 1, speed},
                          {"cost", 1, 1, cost},       {"pictures", 2, 4, pictures}, {"bookmark", 1, 1, bookmark},
                          {"forget", 1, 1, forget},   {"caption", 1, any, caption}, {"wipe", 1, 1, wipe}};

Phase phase_from(std::string_view word) {
    for (const Phase phase : {Phase::refined, Phase::gathered, Phase::pushed_pulled})
        if (name(phase) == word)
            return phase;
    throw BadInput(in_quotes(word) + " is no phase; there are refine, gather and push-pull");
}

} // namespace

int whole(std::string_view word, int least) {
    double value = 0;
    if (!number_from(word, value) || value != std::floor(value) || value < least || value > far_ahead)
        throw BadInput(in_quotes(word) + " is not a whole number of " + std::to_string(least) + " or more");
    return static_cast<int>(value);
}

Place place_from(const Words &words, std::size_t from) {
    const int iteration = whole(words[from], 0);
    const Phase phase = words.size() > from + 1 ? phase_from(words[from + 1]) : Phase::pushed_pulled;
    Place place{iteration == 0 ? 0 : position_of(iteration, phase)};
    if (words.size() > from + 2 && words[from + 2] == "links") {
        if (words.size() == from + 3)
            throw BadInput("how many links?");
        place.linking = whole(words[from + 3], 1);
    } else if (words.size() > from + 2) {
        place.split = whole(words[from + 2], 1);
        if (words.size() > from + 3)
            throw BadInput(in_quotes(words[from + 3]) + " is a word too many");
    }
    return place;
}

std::optional<Act> act_of_words(const Words &words) {
    const auto form = std::ranges::find(forms, words[0], &Form::word);
    if (form == std::end(forms))
        return std::nullopt;
    const std::size_t n = words.size() - 1;
    if (n > form->most || n < form->least)
        throw BadInput(in_quotes(words[0]) + (n > form->most ? " has words too many" : " is not complete"));
    return form->act(words);
}

} // namespace penumbra
