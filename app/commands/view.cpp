#include "commands/command.h"
#include "commands/solving_options.h"
#include "scene/bundled.h"
#include "window/viewer.h"

#include <CLI/Option.hpp>

#include <memory>
#include <string>

namespace penumbra {

namespace {

int run(const SolvingOptions &solving, ViewerSetup setup) {
    const std::optional<Vec3> up = solving.up_vector();
    setup.read_scene = [up](const std::string &name) {
        return std::make_shared<const Scene>(open_scene(name, up));
    };
    // Read here and not in the window, so that a bad file ends the program with its line and status.
    setup.scene = setup.read_scene(solving.scene);
    setup.options = solving.options;
    for (const BundledScene &scene : bundled_scenes())
        setup.bundled_scenes.emplace_back(scene.name);
    Viewer(std::move(setup)).run();
    return done;
}

} // namespace

Command add_view(CLI::App &root) {
    CLI::App *parser = root.add_subcommand("view", "The viewer, on a scene; on the paper's unless one is given");
    const auto solving = std::make_shared<SolvingOptions>();
    const auto setup = std::make_shared<ViewerSetup>();
    solving->scene = "figure-4";
    solving->options.threshold = paper_threshold;
    parser->add_option("FILE", solving->scene, "An OBJ or glTF file, or the name of a bundled scene");
    add_up_option(*parser, *solving);
    add_solving_options(*parser, *solving);
    // For tests, and so not in the help.
    parser->add_option("--state-file", setup->state_file)->group("");
    parser->add_flag("--inert", setup->inert)->group("");
    return {parser, [=] { return run(*solving, *setup); }};
}

} // namespace penumbra
