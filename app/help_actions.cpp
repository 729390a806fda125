#include "menu_actions.h"

#include "tour.h"

namespace penumbra {

std::vector<Action> help_actions() {
    return {
        {"help.keys", Menu::help, "Keys and mouse", "Everything that the window answers to.", {"?", "F1"},
         [](AppState &s) { s.help_open = !s.help_open; }, nullptr, [](const AppState &s) { return s.help_open; }},
        {"help.tour", Menu::help, "Tour", "Six cards on what there is to see; each can show it.", {"Shift+F1"}, toggle_tour,
         nullptr, [](const AppState &s) { return s.tour.open; }},
    };
}

} // namespace penumbra
