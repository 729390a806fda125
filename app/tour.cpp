#include "tour.h"

#include "action.h"
#include "core/check.h"
#include "truth_verbs.h"
#include "verbs.h"

#include <algorithm>
#include <iterator>

namespace penumbra {

namespace {

/// Nothing that lies over the scene, and the light itself.
constexpr Wish bare[] = {{"view.panels", false}, {"help.keys", false}, {"view.keyhole", false}, {"view.profile", false}};

constexpr Wish one_step[] = {{"layers.polynomial"}, {"layers.mesh"}, {"solve.reset"}, {"solve.step"}};
constexpr Wish curves[] = {
    {"layers.polynomial"}, {"strategy.meshing"}, {"layers.mesh"}, {"layers.curves"}, {"layers.legend"}, {"solve.end"}};
constexpr Wish four[] = {{"layers.polynomial"}, {"layers.mesh"}, {"view.four"}};
constexpr Wish keyhole[] = {{"layers.polynomial"}, {"view.single"}, {"layers.curves"}, {"view.keyhole"}};
constexpr Wish errors[] = {{"layers.error"}};
constexpr Wish cost[] = {{"view.cost"}, {"edit.palette"}};

void show_all_curves(AppState &state) { state.look.curve_filter = {}; }

/// At the start there is no patch to compare.
void step_once(AppState &state) {
    if (state.position == 0)
        go_to(state, step_forward(0));
}

void put_all_strategies_in_four(AppState &state) {
    PaneSet &panes = state.pane_sets[pane_set_of(Layout::four)];
    std::ranges::copy(all_strategies, panes.strategies.begin());
    panes.reconstructed.fill(false);
    step_once(state);
}

/// Errors, and not the difference that an effect makes; also where finding them out was given up.
void measure_errors(AppState &state) {
    step_once(state);
    state.look.change.reset();
    show_errors(state, state.look.error);
}

constexpr TourCard cards[] = {
    {"Light, step by step",
     "A lamp lights diffuse surfaces, and they light each other. Each step refines the mesh where the light is not fitted well, "
     "gathers the light along links, and pushes and pulls it through the hierarchy. The arrow keys step; Space plays.",
     one_step},
    {"Curves and cuts",
     "Shadows begin and end on curves that edges and corners throw; there the light or its slope jumps. They are drawn in "
     "the colours of the legend. Discontinuity meshing cuts the patches along them, so that a few patches are enough.",
     curves, show_all_curves},
    {"Four strategies side by side",
     "Uniform or discontinuity meshing, times one value or a polynomial on each patch: the paper\u2019s (a) to (d). All panes "
     "show the same step from the same eye. Compare how many patches each needs, and how wrong it is.",
     four, put_all_strategies_in_four},
    {"The keyhole",
     "What does a point of the floor see of the lamp? The inset shows it, exactly. Drag the point over a surface: where it "
     "crosses a curve, what it sees changes its shape, and a sentence says how.",
     keyhole, step_once},
    {"How wrong is it?",
     "The difference to the true solution in place of the light: too bright, too dark, or right. The legend has the scale. "
     "The side panel chooses the kind of error, and can lock the range so that steps can be compared.",
     errors, measure_errors},
    {"What accuracy costs",
     "The plot on the right puts error against time or work, a point for each step; patches alone are not work. Everything "
     "else is found with Ctrl+K: type a part of its name. The ? shows every key.",
     cost, step_once},
};

void fulfil(AppState &state, const Wish &wish) {
    const Action *action = find_action(wish.action);
    PENUMBRA_CHECK(action != nullptr, ==, true);
    if (!action->checked || is_checked(*action, state) != wish.on)
        run(*action, state);
}

} // namespace

std::span<const TourCard> tour_cards() { return cards; }

void toggle_tour(AppState &state) { state.tour = {!state.tour.open, 0}; }

void turn_tour(AppState &state, int by) {
    state.tour.card = std::clamp(state.tour.card + by, 0, static_cast<int>(std::size(cards)) - 1);
}

bool can_show(const AppState &state) { return state.active_solution() != nullptr; }

void show_card(AppState &state) {
    const TourCard &card = cards[static_cast<std::size_t>(state.tour.card)];
    for (const Wish &wish : bare)
        fulfil(state, wish);
    if (card.prepare)
        card.prepare(state);
    for (const Wish &wish : card.wishes)
        fulfil(state, wish);
}

} // namespace penumbra
