#include "files/pictures_folder.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace penumbra {

namespace {

std::string variable(const char *name) {
    const char *value = std::getenv(name);
    return value ? value : "";
}

/// The value of a line XDG_PICTURES_DIR="$HOME/Pictures"; the file is shell, but the specification (xdg-user-dirs)
/// allows only $HOME/ or an absolute path.
std::filesystem::path chosen_folder(const std::filesystem::path &user_dirs, const std::string &home) {
    std::ifstream file(user_dirs);
    const std::string key = "XDG_PICTURES_DIR=\"", relative = "$HOME";
    for (std::string line; std::getline(file, line);) {
        const auto end = line.rfind('"');
        if (!line.starts_with(key) || end < key.size())
            continue;
        const std::string value = line.substr(key.size(), end - key.size());
        if (value.starts_with(relative))
            return home + value.substr(relative.size());
        if (value.starts_with('/'))
            return value;
    }
    return {};
}

} // namespace

std::filesystem::path pictures_folder() {
    const std::string home = variable("HOME"), config = variable("XDG_CONFIG_HOME");
    const std::filesystem::path folder = config.starts_with('/') ? config : home + "/.config";
    if (const auto chosen = chosen_folder(folder / "user-dirs.dirs", home); !chosen.empty())
        return chosen;
    return home.empty() ? std::filesystem::path(".") : std::filesystem::path(home) / "Pictures";
}

} // namespace penumbra
