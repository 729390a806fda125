// Six cards on what there is to see, for a first start. Checked by tests/gui/tour_test.cpp.
#pragma once

#include "app_state.h"

#include <span>
#include <string_view>

namespace penumbra {

/// An action that a card does, or the state that it leaves a toggle in.
struct Wish {
    std::string_view action;
    bool on = true; ///< of a toggle
};

struct TourCard {
    std::string_view title, text;
    std::span<const Wish> wishes;                ///< done in this order by "Show me"
    void (*prepare)(AppState &state) = nullptr; ///< before them, what no action can; null: nothing
};

std::span<const TourCard> tour_cards();

/// Opens it at the first card, or closes it.
void toggle_tour(AppState &state);
/// To another card, as long as there is one.
void turn_tour(AppState &state, int cards);

/// Whether the card's ground is there: something was solved.
bool can_show(const AppState &state);
/// Does what the open card speaks of, whatever is shown now: toggles end up as the card wants them, and actions that can't be
/// done any more are passed over.
void show_card(AppState &state);

} // namespace penumbra
