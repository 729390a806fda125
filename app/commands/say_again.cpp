#include "commands/say_again.h"

#include <CLI/Option.hpp>

namespace penumbra {

void say_again(const CLI::App &parser) {
    for (CLI::Option *option : parser.parse_order())
        if (!option->get_positional())
            option->run_callback();
}

} // namespace penumbra
