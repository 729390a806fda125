#include "commands/command.h"
#include "commands/interrupt.h"
#include "commands/solving_options.h"
#include "commands/terminal.h"
#include "files/check_table.h"
#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"

#include <algorithm>
#include <memory>

namespace penumbra {

namespace {

constexpr BasisFamily both[] = {BasisFamily::parametric, BasisFamily::planar};

struct CheckOptions {
    std::vector<std::string> scenes;
    CommonOptions common;
    bool json = false;
};

int examine_shelf(const CheckOptions &options, const Cancel &cancel) {
    std::vector<CaseResult> results;
    for (const HardCase &hard_case : hard_cases())
        for (const BasisFamily basis : both)
            results.push_back(examine(hard_case, basis, &cancel));
    deliver(options.common.output, options.json ? check_json(results) : check_text(results, options.common.verbose));
    return all_hold(results) ? done : comparison_failed;
}

int examine_scenes(const CheckOptions &options, const Cancel &cancel) {
    std::vector<std::shared_ptr<const Scene>> scenes; // all are read before the first is solved
    for (const std::string &name : options.scenes) {
        scenes.push_back(std::make_shared<const Scene>(open_scene(name)));
        if (!options.common.quiet)
            say_notes(scenes.back()->notes);
    }
    std::vector<SceneHealth> found;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        for (const BasisFamily basis : both) {
            Options solving;
            solving.basis = basis;
            Solver solver(scenes[i], solving, &cancel);
            solver.run(&cancel);
            const State &state = *solver.state();
            found.push_back({options.scenes[i], basis, health(*scenes[i], state), state.counters, state.peak});
        }
    deliver(options.common.output, options.json ? health_json(found) : health_text(found));
    if (std::ranges::any_of(found, [](const SceneHealth &s) { return s.health.non_finite > 0; }))
        return comparison_failed;
    return std::ranges::all_of(found, [](const SceneHealth &s) { return s.counters.converged; }) ? done : not_reached;
}

int run(const CheckOptions &options) {
    check_deliverable(options.common.output);
    const Interrupt interrupt;
    try {
        return options.scenes.empty() ? examine_shelf(options, interrupt.cancel())
                                      : examine_scenes(options, interrupt.cancel());
    } catch (const Cancelled &) {
        complain("interrupted; nothing was written");
        return interrupt.exit_status();
    }
}

} // namespace

Command add_check(CLI::App &root) {
    CLI::App *parser =
        root.add_subcommand("check", "Numerical health: of the shelf of hard cases, or of the scenes named");
    const auto options = std::make_shared<CheckOptions>();
    parser->add_option("SCENE", options->scenes, "OBJ or glTF files, or names of bundled scenes; none: the hard cases");
    parser->add_flag("--json", options->json, "The same as JSON");
    add_common_options(*parser, options->common, "The table; standard output unless given");
    return {parser, [=] { return run(*options); }};
}

} // namespace penumbra
