// What Jacobi's, Gauss-Seidel's and Southwell's orders take to come to the fixed point, as a Markdown table: see README.md.
#include "iteration/solver.h"
#include "iteration/state.h"
#include "scene/bundled.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace penumbra {

namespace {

constexpr std::array goals{1e-2, 1e-4, 1e-8};

/// Sweeps (links evaluated, over links) from dark surfaces on, over links that stay as they are, until the change that is
/// still to come falls below each goal.
std::array<double, goals.size()> sweeps(const Setting &setting, const State &links) {
    State state = links;
    state.shot.resize(0, 3);
    state.batches.clear();
    state.counters.total_work = {};
    state.irradiance.setZero();
    push_pull(state.forest, *setting.scene, state.irradiance, state.radiosity);
    std::array<double, goals.size()> out{};
    for (std::size_t reached = 0; reached < goals.size();) {
        gather(setting, state, nullptr);
        push_pull(setting, state);
        const double change = state.peak > 0 ? state.counters.change : 1; // nothing reflected yet
        for (; reached < goals.size() && change <= goals[reached]; ++reached)
            out[reached] = static_cast<double>(state.counters.total_work.link_evaluations) /
                           static_cast<double>(state.counters.links);
    }
    return out;
}

void print_row(const char *scene_name, GatherOrder order, Switch coarse) {
    const auto scene = std::make_shared<const Scene>(open_scene(scene_name));
    Options options;
    options.gather = order;
    options.coarse_correction = coarse;
    Solver solver(scene, options);
    solver.run();
    const Counters &c = solver.counters();
    Setting setting{scene, options};
    setting.blockers = std::make_unique<const Blockers>(*scene);
    const auto needed = sweeps(setting, *solver.state());
    std::printf("| %s | %s%s | %.1f | %.1f | %.1f | %d | %.1f |\n", scene_name, std::string(name(order)).c_str(),
                coarse == Switch::on ? ", coarse correction" : "", needed[0], needed[1], needed[2], c.iteration,
                static_cast<double>(c.total_work.link_evaluations) / static_cast<double>(c.links));
    std::fflush(stdout);
}

} // namespace

} // namespace penumbra

int main() {
    using namespace penumbra;
    for (const char *scene : {"furnace", "cornell-box", "stairs", "next-room"})
        for (const Switch coarse : {Switch::off, Switch::on})
            for (const GatherOrder order : all_gather_orders)
                print_row(scene, order, coarse);
}
