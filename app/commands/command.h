// The verbs of the command line: each adds its options to the parser and says what runs when it is chosen.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <functional>
#include <vector>

namespace penumbra {

/// Exit statuses that no exception stands for (BadInput is 3, Unavailable 5; an interrupt 128 + the signal).
enum ExitStatus { done = 0, comparison_failed = 1, wrong_use = 2, bad_input = 3, not_reached = 4, unavailable = 5 };

struct Command {
    CLI::App *parser = nullptr;
    std::function<int()> run; ///< gives the exit status; throws BadInput, Unavailable
};

// A file each in commands/.
Command add_check(CLI::App &root);
Command add_cost(CLI::App &root);
Command add_curves(CLI::App &root);
Command add_paper(CLI::App &root);
Command add_render(CLI::App &root);
Command add_scenes(CLI::App &root);
Command add_solve(CLI::App &root);
Command add_view(CLI::App &root);

/// All verbs, in the order of the help.
std::vector<Command> add_commands(CLI::App &root);

} // namespace penumbra
