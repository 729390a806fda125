// Arguments only: which verb, and what its errors mean to the shell.
#include "commands/command.h"
#include "commands/terminal.h"
#include "core/error.h"

#include <algorithm>
#include <csignal>
#include <new>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace penumbra;

/// `penumbra`, `penumbra FILE` and `penumbra --order 3 FILE` mean the viewer.
std::vector<std::string> with_verb(std::vector<std::string> arguments, const std::vector<Command> &commands) {
    const auto is_verb = [&](const std::string &word) {
        return std::ranges::any_of(commands, [&](const Command &c) { return c.parser->get_name() == word; });
    };
    const auto asks_root = [](const std::string &word) { return word == "-h" || word == "--help" || word == "--version"; };
    if (arguments.empty() || (!is_verb(arguments[0]) && !asks_root(arguments[0])))
        arguments.insert(arguments.begin(), "view");
    return arguments;
}

int run(std::vector<std::string> arguments) {
    CLI::App root("Penumbra: discontinuity meshing and hierarchical multiwavelet radiosity, step by step", "penumbra");
    root.set_version_flag("--version", "penumbra " PENUMBRA_VERSION);
    root.require_subcommand(1);
    const std::vector<Command> commands = add_commands(root);
    arguments = with_verb(std::move(arguments), commands);
    try {
        root.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend())); // CLI11 takes them backwards
    } catch (const CLI::ParseError &e) {
        if (e.get_exit_code() == 0) { // help and version
            std::ostringstream text;
            root.exit(e, text, text);
            deliver("", text.str());
            return 0;
        }
        complain(std::string(e.what()) + "; see penumbra " + arguments.front() + " --help");
        return wrong_use;
    }
    for (const Command &command : commands)
        if (command.parser->parsed())
            return command.run();
    return wrong_use;
}

} // namespace

int main(int argc, char **argv) {
    std::signal(SIGXFSZ, SIG_IGN); // a file that grows beyond what is allowed is an error of its write, as a full disk is
    try {
        return run({argv + 1, argv + argc});
    } catch (const BadInput &e) {
        complain(e.what());
        return bad_input;
    } catch (const Unavailable &e) {
        complain(e.what());
        return unavailable;
    } catch (const std::bad_alloc &) {
        complain("out of memory; raise --threshold or lower --max-depth");
        return not_reached;
    } catch (const std::exception &e) {
        complain(std::string("internal error: ") + e.what());
        return comparison_failed;
    }
}
