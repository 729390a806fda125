// What was done in the window, in the words of scripts (commands/read_script.h).
#pragma once

#include "scripted.h"

#include <string>
#include <vector>

namespace penumbra {

/// Lines that lead a window that rests from the one to the other. The position far_ahead is the end; where the one was
/// playing, the way to the other's place was played. Numbers have all their digits. Checked by tests/gui/record_test.cpp.
std::vector<std::string> lines_between(const Scripted &from, const Scripted &to);

/// `go` to the other's place, "go 2 refine 17", or `play` up to it.
std::vector<std::string> way_to(const Scripted &to, bool played);

} // namespace penumbra
