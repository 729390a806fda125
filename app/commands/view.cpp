#include "commands/command.h"
#include "commands/read_script.h"
#include "commands/say_again.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "files/open_file.h"
#include "files/pictures_folder.h"
#include "scene/bundled.h"
#include "window/viewer.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace penumbra {

namespace {

struct ScriptOptions {
    std::filesystem::path file, pictures; ///< empty: no script; the folder of pictures
    double pace = 1;
};

int run(const CLI::App &parser, SolvingOptions &solving, ViewerSetup setup, const ScriptOptions &script) {
    const std::optional<Vec3> up = solving.up_vector();
    setup.read_file = [up](const std::string &name) { return open_file(name, up); };
    // Read here and not in the window, so that a bad file ends the program with its line and status.
    setup.file = open_file(solving.scene, up, solving.moves);
    setup.file_name = solving.scene;
    setup.state_in_file = setup.file.state;
    if (auto &state = setup.file.state) {
        solving.options = state->options;
        say_again(parser);
        state->options = solving.options;
        if (parser.count("--strategy") > 0)
            state->strategies[static_cast<std::size_t>(state->active)] = solving.options.strategy;
        say_notes(state->notes);
    }
    setup.options = solving.options;
    setup.memory_limit = solving.limits.memory_mib;
    for (const BundledScene &scene : bundled_scenes())
        setup.bundled_scenes.emplace_back(scene.name);
    if (!script.file.empty())
        setup.script = read_script(script.file, script.pictures.empty() ? pictures_folder() : script.pictures, script.pace);
    const ViewerEnd end = Viewer(std::move(setup)).run();
    if (end.signal == 0)
        return done;
    complain("interrupted; " + end.words);
    return 128 + end.signal;
}

} // namespace

Command add_view(CLI::App &root) {
    CLI::App *parser = root.add_subcommand("view", "The viewer, on a scene, a saved state or a picture; on the paper's scene unless one is given");
    const auto solving = std::make_shared<SolvingOptions>();
    const auto setup = std::make_shared<ViewerSetup>();
    const auto script = std::make_shared<ScriptOptions>();
    solving->scene = "figure-4";
    solving->options.threshold = paper_threshold;
    parser->add_option("FILE", solving->scene,
                       "An OBJ or glTF file, the name of a bundled scene, a saved state (.penumbra.json), or a PNG that "
                       "Penumbra wrote");
    add_up_option(*parser, *solving);
    add_solving_options(*parser, *solving);
    parser->remove_option(parser->get_option("--time-limit")); // a window is stopped by hand
    parser->add_option("--script", script->file, "Does in the window what this file says, line by line; Esc stops it");
    parser->add_option("--pictures", script->pictures, "Where the script's pictures go; the folder of pictures unless given");
    parser->add_option("--pace", script->pace, "The script's waits are multiplied by this; 0: it does not wait")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    parser->add_option("--record", setup->record,
                       "Writes what is done in the window to this file, as a script that --script does again");
    // For tests and measuring, and so not in the help.
    parser->add_option("--state-file", setup->state_file)->group("");
    parser->add_option("--frame-times", setup->frame_times)->group("");
    parser->add_flag("--inert", setup->inert)->group("");
    parser->add_flag("--lose-context", setup->lose_context)->group("");
    return {parser, [=] { return run(*parser, *solving, *setup, *script); }};
}

} // namespace penumbra
