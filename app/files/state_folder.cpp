#include "files/state_folder.h"

#include <cstdlib>

namespace penumbra {

std::filesystem::path state_folder() {
    const char *state = std::getenv("XDG_STATE_HOME"), *home = std::getenv("HOME");
    if (state && *state == '/')
        return std::filesystem::path(state) / "penumbra";
    return std::filesystem::path(home ? home : ".") / ".local/state/penumbra";
}

} // namespace penumbra
