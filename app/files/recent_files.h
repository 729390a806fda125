// Files that were opened lately, in $XDG_STATE_HOME/penumbra/recent.json. Checked by tests/unit/recent_files_test.cpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

inline constexpr std::size_t most_recent_files = 10;

/// Absolute paths, the latest first, each once.
using RecentFiles = std::vector<std::string>;

std::filesystem::path recent_files_file();

/// Passes over what is no absolute path. Throws BadInput for what is no such list.
RecentFiles read_recent_files(const std::string &file, std::string_view text);
/// Of recent_files_file(); none where that is missing or bad.
RecentFiles read_recent_files();
std::string recent_files_text(const RecentFiles &files);

/// With this file first; the eleventh falls away.
RecentFiles with_latest(RecentFiles files, const std::string &file);
/// Those that are there now.
RecentFiles that_exist(const RecentFiles &files);

/// Notes that a scene, a state or a picture was opened by this name, and returns the list; other windows may have added to it
/// since it was last read. What names no regular file, as bundled scenes do not, is not noted. Throws Unavailable when the list
/// can't be written.
RecentFiles note_recent_file(const std::string &name);

} // namespace penumbra
