// Where pictures that are taken in the window go.
#pragma once

#include <filesystem>

namespace penumbra {

/// The desktop's Pictures folder: XDG_PICTURES_DIR of $XDG_CONFIG_HOME/user-dirs.dirs, else $HOME/Pictures; the present
/// folder where there is no home.
std::filesystem::path pictures_folder();

} // namespace penumbra
