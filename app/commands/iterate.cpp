#include "commands/iterate.h"

namespace penumbra {

std::vector<Counters> iterate(Solver &solver, int most, const Cancel &cancel, Progress &progress) {
    std::vector<Counters> iterations;
    std::shared_ptr<const State> complete = solver.state();
    try {
        while (!solver.ended() && static_cast<int>(iterations.size()) < most) {
            solver.step(&cancel);
            complete = solver.state();
            iterations.push_back(solver.counters());
            progress.show(iterations.back());
        }
    } catch (const Cancelled &) {
        solver.restore(complete);
    }
    return iterations;
}

} // namespace penumbra
