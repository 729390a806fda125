#include "commands/command.h"
#include "commands/interrupt.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "core/error.h"
#include "files/curve_arrangement.h"
#include "files/curve_csv.h"
#include "files/curve_svg.h"
#include "iteration/solver.h"
#include "scene/scene.h"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace penumbra {

namespace {

struct CurvesOptions {
    SolvingOptions solving;
    CommonOptions common;
    std::string svg, arrangement;
};

void make_folder(const std::filesystem::path &folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw Unavailable("cannot create " + folder.string() + ": " + failure.message());
}

void write_receivers(const CurvesOptions &options, const Snapshot &snapshot) {
    const auto write = [&](const std::filesystem::path &folder, const std::pair<std::string, std::string> &file) {
        if (!folder.empty())
            deliver((folder / file.first).string(), file.second);
    };
    for (const std::string &folder : {options.svg, options.arrangement})
        if (!folder.empty())
            make_folder(folder);
    for (const ReceiverCurves &curves : arrange_receivers(snapshot)) {
        write(options.svg, curve_drawing(snapshot, curves));
        write(options.arrangement, arrangement_json(snapshot, curves));
    }
}

int run(const CurvesOptions &options) {
    check_deliverable(options.common.output);
    const auto scene = std::make_shared<const Scene>(open_scene(options.solving, options.common));
    const Interrupt interrupt;
    try {
        const Solver solver(scene, options.solving.options, &interrupt.cancel());
        const auto snapshot = solver.snapshot();
        deliver(options.common.output, curve_csv(*snapshot->curves));
        if (!options.svg.empty() || !options.arrangement.empty())
            write_receivers(options, *snapshot);
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
    parser->add_option("--arrangement", options->arrangement,
                       "A folder for the regions of each receiver as JSON: vertices, edges with their curves, faces");
    return {parser, [=] { return run(*options); }};
}

} // namespace penumbra
