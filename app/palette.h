// Everything that can be done, found by typing a part of its name.
#pragma once

#include "app_state.h"

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

struct Action;

/// An action, or a bundled scene or recent file to open.
struct PaletteEntry {
    std::string title, help, key;
    const Action *action = nullptr; ///< null: `file` is opened
    std::string file;
    bool enabled = true;
};

/// Those in whose title, sentence or name every typed word occurs, best first: words that titles begin with before those that
/// begin a word of them, before those inside, before those of sentences and names; in the menus' order where that is even.
/// All, where nothing is typed.
std::vector<PaletteEntry> palette_entries(const AppState &state, std::string_view typed);

/// Does what the entry stands for and closes the palette.
void choose(AppState &state, const PaletteEntry &entry);

} // namespace penumbra
