#include "menu_actions.h"

#include "verbs.h"

namespace penumbra {

namespace {

template <Strategy strategy>
void use_strategy(AppState &s) {
    set_strategy(s, strategy);
}
template <Strategy strategy>
bool uses_strategy(const AppState &s) {
    return s.active_strategy() == strategy;
}
void flip_meshing(AppState &s) {
    const Strategy now = s.active_strategy();
    set_strategy(s, strategy_of(!cuts_along_curves(now), is_constant(now)));
}
void flip_basis(AppState &s) {
    const Strategy now = s.active_strategy();
    set_strategy(s, strategy_of(cuts_along_curves(now), !is_constant(now)));
}

} // namespace

std::vector<Action> strategy_actions() {
    return {
        {"strategy.a", Menu::strategy, "(a) Uniform meshing, constant basis",
         "Splits in four where the fit is poor; one value a patch.", {"1"}, use_strategy<Strategy::uniform_constant>,
         nullptr, uses_strategy<Strategy::uniform_constant>},
        {"strategy.b", Menu::strategy, "(b) Discontinuity meshing, constant basis",
         "Cuts along shadow boundaries; one value a patch.", {"2"}, use_strategy<Strategy::discontinuity_constant>,
         nullptr, uses_strategy<Strategy::discontinuity_constant>},
        {"strategy.c", Menu::strategy, "(c) Uniform meshing, multiwavelet basis",
         "Splits in four where the fit is poor; a polynomial on each patch.", {"3"},
         use_strategy<Strategy::uniform_wavelet>, nullptr, uses_strategy<Strategy::uniform_wavelet>},
        {"strategy.d", Menu::strategy, "(d) Discontinuity meshing, multiwavelet basis",
         "Cuts along shadow boundaries; a polynomial on each patch.", {"4"},
         use_strategy<Strategy::discontinuity_wavelet>, nullptr, uses_strategy<Strategy::discontinuity_wavelet>},
        {"strategy.meshing", Menu::strategy, "Discontinuity meshing",
         "Cut along shadow boundaries, or split uniformly.", {"U"}, flip_meshing, nullptr,
         [](const AppState &s) { return cuts_along_curves(s.active_strategy()); }},
        {"strategy.basis", Menu::strategy, "Multiwavelet basis", "A polynomial on each patch, or one value.", {"Shift+U"},
         flip_basis, nullptr, [](const AppState &s) { return !is_constant(s.active_strategy()); }},
        {"strategy.reconstructed", Menu::strategy, "Constants as quadratics",
         "Draws (a) or (b) as in 1993: quadratics through what the links bring to nodes of each patch, for the eye alone.",
         {"Q"}, toggle_reconstruction, [](const AppState &s) { return is_constant(s.active_strategy()); },
         [](const AppState &s) { return s.reconstructs(s.panes().active); }},
    };
}

} // namespace penumbra
