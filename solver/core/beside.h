// Files that a file names: only its own folder and what is below are looked into.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace penumbra {

/// The regular file called `name` in the folder of `file` or below; nothing when there is none, or where the name leads
/// elsewhere (absolute, or `..`). A backslash is a slash.
std::optional<std::filesystem::path> beside(const std::filesystem::path &file, std::string name);

} // namespace penumbra
