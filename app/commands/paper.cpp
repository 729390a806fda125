#include "capture.h"
#include "commands/command.h"
#include "commands/interrupt.h"
#include "commands/iterate.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "core/parallel.h"
#include "files/paper_table.h"
#include "files/picture_state.h"
#include "files/write_state.h"
#include "render/picture.h"
#include "window/offscreen.h"

#include <CLI/Option.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace penumbra {

namespace {

void make_folder(const std::filesystem::path &folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Unavailable("cannot make the folder " + folder.string() + ": " + error.message());
}

/// As in print: light, and the patches made last are like all others.
PictureSpec on_paper(int width, int height) {
    PictureSpec spec;
    spec.width = width;
    spec.height = height;
    spec.look.theme = Theme::light;
    spec.look.emphasise_fresh = false;
    return spec;
}

/// Floor and blocker fill the frame, the lamp is above it. From the lamp's side: seen from the other one, or from right above,
/// the blocker would stand before the penumbra.
Camera from_the_lamps_side(const Snapshot &snapshot, double aspect) {
    Camera camera;
    camera.target = {0, 0, 0};
    camera.eye = {-0.45, -1.0, 1.1};
    camera.fov_y = 24;
    return fit(camera, snapshot, aspect, Subject::all_but_lamps);
}

void draw(PictureSpec spec, const Scene &scene, const std::filesystem::path &file) {
    spec.camera = from_the_lamps_side(*spec.panes.front().snapshot, pane_aspect(spec));
    write_png(file, draw_picture(spec), state_text(picture_state(spec, scene, file.parent_path())));
}

int run(const SolvingOptions &solving, const CommonOptions &common) {
    const std::filesystem::path folder = common.output;
    make_folder(folder);
    const auto scene = std::make_shared<const Scene>(open_scene(solving, common));
    const Offscreen context;
    set_threads(solving.options.threads);
    const Interrupt interrupt(solving.limits);

    Solutions solutions;
    bool converged = true;
    // The first solution would pay for the start of the worker threads: one is made and thrown away.
    try {
        Solver(scene, solving.options, &interrupt.cancel()).run(&interrupt.cancel());
    } catch (const Cancelled &) {
    }
    for (const Strategy strategy : all_strategies) {
        Options options = solving.options;
        options.strategy = strategy;
        try {
            Solver solver(scene, options, &interrupt.cancel());
            Progress progress(options, common.quiet, common.verbose);
            iterate(solver, options.max_iterations, interrupt.cancel(), progress);
            if (interrupt.exit_status() != done)
                break;
            converged &= solver.converged();
            solutions.push_back(solver.snapshot(true));
        } catch (const Cancelled &) {
            break;
        }
    }
    if (const int status = interrupt.exit_status(); status != done) {
        complain(interrupt.sentence() + " before all four strategies were solved; nothing was written");
        return status;
    }

    PictureSpec sheet = on_paper(1600, 1340);
    sheet.columns = 2;
    for (const auto &s : solutions)
        sheet.panes.push_back({s, std::string("(") + "abcd"[sheet.panes.size()] + ")"});
    std::vector<const Snapshot *> all;
    for (const auto &s : solutions)
        all.push_back(s.get());
    sheet.look.range = common_range(all);
    for (std::size_t i = 0; i < solutions.size(); ++i) { // the paper's figures 5 to 8 show (a) to (d)
        PictureSpec figure = on_paper(1200, 1000);
        figure.panes = {sheet.panes[i]};
        figure.look.range = sheet.look.range;
        draw(figure, *scene, folder / ("figure-" + std::to_string(5 + i) + ".png"));
    }
    draw(sheet, *scene, folder / "sheet.png");
    write_atomically(folder / "table.csv", paper_csv(solutions));
    write_atomically(folder / "table.txt", paper_text(solutions));
    if (!common.quiet)
        deliver("", paper_text(solutions));
    if (!converged) {
        complain("a fixed point was not reached in " + std::to_string(solving.options.max_iterations) +
                 " iterations; raise --max-iterations or --threshold");
        return not_reached;
    }
    return done;
}

} // namespace

Command add_paper(CLI::App &root) {
    CLI::App *parser = root.add_subcommand("paper", "The paper's figures 5 to 8, all four on a sheet, and its table");
    const auto solving = std::make_shared<SolvingOptions>();
    const auto common = std::make_shared<CommonOptions>();
    solving->scene = "figure-4";
    solving->options.threshold = paper_threshold;
    add_solving_options(*parser, *solving);
    parser->remove_option(parser->get_option("--strategy")); // it shows all four
    add_common_options(*parser, *common, "The folder that is written to; made when it is missing");
    parser->get_option("--output")->required();
    return {parser, [=] { return run(*solving, *common); }};
}

} // namespace penumbra
