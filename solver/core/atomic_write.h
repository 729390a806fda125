// Files appear whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace penumbra {

/// Writes `bytes` to a temporary file beside `path`, flushes it and renames it. Throws Unavailable (a full disk, a
/// read-only folder) and then leaves neither a part nor the temporary file; a file that was there stays as it was.
/// Devices and pipes are written to directly.
void write_atomically(const std::filesystem::path &path, std::string_view bytes);

} // namespace penumbra
