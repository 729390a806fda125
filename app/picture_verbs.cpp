#include "picture_verbs.h"

#include "core/error.h"
#include "files/pictures_folder.h"
#include "iteration/error_map.h"
#include "verbs.h"

#include "capture.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

namespace penumbra {

namespace {

bool is_there(const AppState &state, Strategy strategy, int position) {
    return state.timeline(strategy).reached(position) && state.timeline(strategy).at(position);
}

/// Begun anew: what was cancelled or halted before does not hold it up.
void begin(AppState &state, std::deque<PendingPicture> pictures) {
    state.playing = false;
    state.truth.halted = false;
    if (!state.pictures.pending.empty()) // the first of which may be in hand
        state.pictures.drawn.reset();
    state.pictures.pending = std::move(pictures);
}

} // namespace

std::vector<int> pictured_panes(const AppState &state) {
    if (state.layout == Layout::flip)
        return {state.panes().active};
    std::vector<int> all;
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        all.push_back(pane);
    return all;
}

void compare_meshings(AppState &state) {
    const bool constant = is_constant(state.active_strategy());
    begin(state, {{.run = state.run,
                   .strategies = {strategy_of(false, constant), strategy_of(true, constant)},
                   .reconstructed = {false, false},
                   .layout = Layout::two,
                   .positions = {state.shown_position(), state.shown_position()},
                   .file = {},
                   .title = "Picture of both meshings"}});
}

void picture_all_steps(AppState &state) {
    const int last = state.shown_position(), n = iteration_of(last) + 1;
    const auto digits = static_cast<int>(std::to_string(n - 1).size());
    std::filesystem::path folder;
    try {
        folder = numbered_name(pictures_folder(), "penumbra-steps", "");
        std::filesystem::create_directory(folder);
    } catch (const std::exception &e) {
        state.message = {e.what(), true};
        return;
    }
    PendingPicture picture{.run = state.run,
                           .strategies = {},
                           .reconstructed = {},
                           .layout = state.layout,
                           .positions = {},
                           .file = {},
                           .title = {}};
    std::vector<bool> steps; // or stays at a step of its own
    for (const int pane : pictured_panes(state)) {
        picture.strategies.push_back(state.strategy_of(pane));
        picture.reconstructed.push_back(state.reconstructs(pane));
        picture.positions.push_back(state.asked_position(pane));
        steps.push_back(!state.has_own_steps() || pane == state.panes().active);
    }
    if (picture.strategies.size() == 1)
        picture.layout = Layout::single;
    std::deque<PendingPicture> all;
    for (int step = 0; step < n; ++step) {
        for (std::size_t pane = 0; pane < steps.size(); ++pane)
            if (steps[pane])
                picture.positions[pane] = std::min(step_position(step), last);
        picture.file = folder / fmt::format("step-{:0{}}.png", step, digits);
        picture.title = fmt::format("Picture {} of {}", step + 1, n);
        all.push_back(picture);
    }
    begin(state, std::move(all));
}

void drop_pictures(AppState &state) {
    const std::size_t n = std::max<std::size_t>(state.pictures.pending.size(), 1); // that is drawn without having waited
    state.pictures.pending.clear();
    state.pictures.drawn.reset();
    state.cancel_request |= state.halted; // else the solver's goal is again what is shown
    state.message = {n == 1 ? "No picture was taken." : fmt::format("{} pictures were not taken.", n), false};
}

std::shared_ptr<const Snapshot> pictured(const AppState &state, const PendingPicture &picture, std::size_t pane) {
    const Strategy strategy = picture.strategies[pane];
    const int position = picture.positions[pane];
    if (!is_there(state, strategy, position))
        return nullptr;
    auto solution = state.timeline(strategy).at(position);
    if (!picture.reconstructed[pane])
        return solution;
    const auto found = state.reconstructions.find(solution->version);
    return found == state.reconstructions.end() ? nullptr : found->second;
}

std::shared_ptr<const ErrorMap> pictured_errors(const AppState &state, const Judging &judging) {
    const auto found = state.truth.maps.find({judging.solution->version, judging.against()});
    const bool known = found != state.truth.maps.end() && (judging.minus || found->second->change == state.look.change);
    return known ? found->second : nullptr;
}

namespace {

/// What of it is held against something, as far as it is known.
std::vector<Judging> judgings(const AppState &state, const PendingPicture &picture) {
    std::vector<Judging> all;
    if (picture.layout == Layout::difference) {
        const auto minus = pictured(state, picture, 0), solution = pictured(state, picture, 1);
        if (minus && solution)
            all.push_back({solution, minus});
    } else if (state.look.shading == Shading::error) {
        for (std::size_t pane = 0; pane < picture.strategies.size(); ++pane)
            if (auto solution = pictured(state, picture, pane))
                all.push_back({std::move(solution), nullptr});
    }
    return all;
}

} // namespace

Readiness readiness(const AppState &state, const PendingPicture &picture) {
    if (picture.run != state.run)
        return Readiness::hopeless;
    for (std::size_t pane = 0; pane < picture.strategies.size(); ++pane) {
        const Timeline &timeline = state.timeline(picture.strategies[pane]);
        if (timeline.ended && timeline.moments.empty())
            return Readiness::hopeless;
        if (!pictured(state, picture, pane))
            return Readiness::waiting;
    }
    const auto known = [&](const Judging &judging) { return pictured_errors(state, judging) != nullptr; };
    return std::ranges::all_of(judgings(state, picture), known) ? Readiness::ready : Readiness::waiting;
}

std::optional<Goal> picture_goal(const AppState &state) {
    if (state.pictures.pending.empty() || !state.scene)
        return std::nullopt;
    const PendingPicture &picture = state.pictures.pending.front();
    Goal goal{picture.run, state.scene, state.options};
    bool wanted = false;
    for (std::size_t pane = 0; pane < picture.strategies.size(); ++pane) {
        const Stand stand{picture.strategies[pane], picture.positions[pane]};
        wanted |= !pictured(state, picture, pane);
        goal.stands.push_back(stand);
        if (picture.reconstructed[pane])
            goal.reconstructed.push_back(stand);
    }
    return wanted && picture.run == state.run ? std::optional(std::move(goal)) : std::nullopt;
}

std::vector<Judging> to_be_judged(const AppState &state) {
    std::vector<Judging> all;
    if (state.pictures.pending.empty())
        return all;
    for (Judging &judging : judgings(state, state.pictures.pending.front()))
        if (!pictured_errors(state, judging) && std::ranges::find(all, judging) == all.end())
            all.push_back(std::move(judging));
    return all;
}

std::string picture_progress(const AppState &state) {
    const std::string title = state.pictures.pending.empty() ? "The picture" : state.pictures.pending.front().title;
    if (state.pictures.drawn)
        return fmt::format("{} is being drawn: {:.0f} %. Esc gives it up.", title, 100 * *state.pictures.drawn);
    if (state.pictures.pending.empty())
        return {};
    const PendingPicture &picture = state.pictures.pending.front();
    for (std::size_t pane = 0; pane < picture.strategies.size(); ++pane)
        if (const Strategy strategy = picture.strategies[pane]; !is_there(state, strategy, picture.positions[pane]))
            return fmt::format("{}: ({}) is being solved up to step {} first; it has come to step {}. Esc gives it up.",
                               picture.title, letter(strategy), iteration_of(picture.positions[pane]),
                               iteration_of(std::max(0, state.timeline(strategy).last())));
    return picture.title + (readiness(state, picture) == Readiness::waiting ? ": its errors are being measured first. "
                                                                            : "; ") +
           "Esc stops.";
}

} // namespace penumbra
