#include "commands/command.h"

namespace penumbra {

std::vector<Command> add_commands(CLI::App &root) {
    return {
        add_view(root),
        add_solve(root),
        add_render(root),
        add_paper(root),
        add_cost(root),
        add_curves(root),
        add_check(root),
        add_scenes(root),
    };
}

} // namespace penumbra
