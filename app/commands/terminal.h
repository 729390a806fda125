// What the program says: data on standard output, everything else on standard error.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

/// One line on standard error, headed by the program's name; in colour on a terminal unless NO_COLOR is set.
void complain(const std::string &what);

/// A line each on standard error, headed by "note:".
void say_notes(const std::vector<std::string> &notes);

bool error_is_terminal();

/// Whole or not at all: to the file atomically, or to standard output when `file` is empty or "-". Throws Unavailable.
void deliver(const std::string &file, std::string_view bytes);

/// Throws Unavailable when `file`'s folder is not there or not writable: better now than after an hour's work. Empty and
/// "-" pass.
void check_deliverable(const std::string &file);

} // namespace penumbra
