// Options that stand beside a saved state.
#pragma once

#include <CLI/App.hpp>

namespace penumbra {

/// Once more does what every option given on the command line does, but for positional ones: after a state has been
/// taken over, what was said beside it holds.
void say_again(const CLI::App &parser);

} // namespace penumbra
