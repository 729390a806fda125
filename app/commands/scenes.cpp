#include "commands/command.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "scene/bundled.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>

namespace penumbra {

Command add_scenes(CLI::App &root) {
    CLI::App *parser = root.add_subcommand("scenes", "The bundled scenes, with a line on each");
    const auto common = std::make_shared<CommonOptions>();
    add_common_options(*parser, *common, "The list; standard output unless given");
    return {parser, [common] {
                std::size_t longest = 0;
                for (const BundledScene &scene : bundled_scenes())
                    longest = std::max(longest, scene.name.size());
                std::string text;
                for (const BundledScene &scene : bundled_scenes())
                    text += fmt::format("{:<{}}  {}\n", scene.name, longest, scene.description());
                deliver(common->output, text);
                return done;
            }};
}

} // namespace penumbra
