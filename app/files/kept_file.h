// Files in the program's own folders.
#pragma once

#include <filesystem>
#include <string_view>

namespace penumbra {

/// Atomically; makes the folder where it is missing. Throws Unavailable with the file and the reason.
void write_kept_file(const std::filesystem::path &file, std::string_view bytes);

} // namespace penumbra
