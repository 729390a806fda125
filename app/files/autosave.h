// Where a window keeps what it shows while it is open, so that it can be restored when the program ends unexpectedly:
// $XDG_STATE_HOME/penumbra/autosave-PID.penumbra.json, a saved state. Checked by tests/unit/autosave_test.cpp and
// tests/gui/autosave_test.cpp.
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra {

/// Of this process.
std::filesystem::path autosave_file();

/// Autosaves of processes that no longer exist, the latest first. One that bears the number of this process is from an earlier
/// one: to be asked before autosave_file() is written, it is given the number 0 then.
std::vector<std::filesystem::path> orphaned_autosaves();

} // namespace penumbra
