// Where the program keeps what it may need again by itself.
#pragma once

#include <filesystem>

namespace penumbra {

/// $XDG_STATE_HOME/penumbra, else $HOME/.local/state/penumbra; a relative XDG_STATE_HOME counts for nothing, as its
/// specification asks.
std::filesystem::path state_folder();

/// What a user has chosen: $XDG_CONFIG_HOME/penumbra, else $HOME/.config/penumbra, by the same rule.
std::filesystem::path config_folder();

/// What can be made again: $XDG_CACHE_HOME/penumbra, else $HOME/.cache/penumbra, by the same rule.
std::filesystem::path cache_folder();

} // namespace penumbra
