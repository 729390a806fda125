#include "core/beside.h"

#include <algorithm>

namespace penumbra {

std::optional<std::filesystem::path> beside(const std::filesystem::path &file, std::string name) {
    std::ranges::replace(name, '\\', '/');
    const std::filesystem::path relative = std::filesystem::path(name).lexically_normal();
    if (relative.empty() || relative.is_absolute() || *relative.begin() == "..")
        return std::nullopt;
    const std::filesystem::path found = file.parent_path() / relative;
    std::error_code none;
    return std::filesystem::is_regular_file(found, none) ? std::optional(found) : std::nullopt;
}

} // namespace penumbra
