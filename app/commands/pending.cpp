#include "commands/command.h"

#include "commands/terminal.h"

#include <string>

namespace penumbra {

Command add_pending(CLI::App &root, const char *name, const char *does) {
    CLI::App *parser = root.add_subcommand(name, std::string(does) + " (still to come)");
    parser->allow_extras();
    return {parser, [name] {
                complain(std::string(name) + " is still to come; see penumbra --help for what is there");
                return wrong_use;
            }};
}

} // namespace penumbra
