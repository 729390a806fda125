#include "commands/command.h"
#include "commands/terminal.h"
#include "scene/bundled.h"

#include <fmt/format.h>

namespace penumbra {

Command add_scenes(CLI::App &root) {
    CLI::App *parser = root.add_subcommand("scenes", "The bundled scenes, with a line on each");
    return {parser, [] {
                std::string text;
                for (const BundledScene &scene : bundled_scenes())
                    text += fmt::format("{:<14} {}\n", scene.name, scene.description());
                deliver("", text);
                return done;
            }};
}

} // namespace penumbra
