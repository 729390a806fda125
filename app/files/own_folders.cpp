#include "files/own_folders.h"

#include <cstdlib>

namespace penumbra {

namespace {

std::filesystem::path folder(const char *variable, const char *in_home) {
    const char *named = std::getenv(variable), *home = std::getenv("HOME");
    if (named && *named == '/')
        return std::filesystem::path(named) / "penumbra";
    return std::filesystem::path(home ? home : ".") / in_home / "penumbra";
}

} // namespace

std::filesystem::path state_folder() { return folder("XDG_STATE_HOME", ".local/state"); }
std::filesystem::path config_folder() { return folder("XDG_CONFIG_HOME", ".config"); }
std::filesystem::path cache_folder() { return folder("XDG_CACHE_HOME", ".cache"); }

} // namespace penumbra
