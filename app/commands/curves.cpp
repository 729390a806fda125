#include "commands/command.h"
#include "commands/interrupt.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "core/error.h"
#include "files/curve_csv.h"
#include "files/curve_svg.h"
#include "iteration/solver.h"
#include "scene/scene.h"

#include <filesystem>
#include <memory>

namespace penumbra {

namespace {

struct CurvesOptions {
    SolvingOptions solving;
    CommonOptions common;
    std::string svg;
};

void write_drawings(const std::filesystem::path &folder, const Snapshot &snapshot) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw Unavailable("cannot create " + folder.string() + ": " + failure.message());
    for (const auto &[file, text] : curve_drawings(snapshot))
        deliver((folder / file).string(), text);
}

int run(const CurvesOptions &options) {
    check_deliverable(options.common.output);
    const auto scene = std::make_shared<const Scene>(open_scene(options.solving, options.common));
    const Interrupt interrupt;
    try {
        const Solver solver(scene, options.solving.options, &interrupt.cancel());
        const auto snapshot = solver.snapshot();
        deliver(options.common.output, curve_csv(*snapshot->curves));
        if (!options.svg.empty())
            write_drawings(options.svg, *snapshot);
    } catch (const Cancelled &) {
        complain("interrupted; nothing was written");
        return interrupt.exit_status();
    }
    return done;
}

} // namespace

Command add_curves(CLI::App &root) {
    CLI::App *parser = root.add_subcommand("curves", "The discontinuity curves of all emitters");
    const auto options = std::make_shared<CurvesOptions>();
    add_scene_options(*parser, options->solving);
    add_common_options(*parser, options->common, "CSV of the curves");
    parser->get_option("-o")->required();
    parser->add_option("--svg", options->svg, "A folder for a drawing of each receiver");
    return {parser, [=] { return run(*options); }};
}

} // namespace penumbra
