#include "commands/iterate.h"

#include "iteration/state.h"

namespace penumbra {

std::vector<Counters> iterate(Solver &solver, int most, const Cancel &cancel, Progress &progress,
                              std::shared_ptr<const State> *best) {
    std::vector<Counters> iterations;
    std::shared_ptr<const State> complete = solver.state();
    try {
        while (!solver.ended() && static_cast<int>(iterations.size()) < most) {
            solver.step(&cancel);
            complete = solver.state();
            const Counters &c = complete->counters;
            if (best && c.estimated_error >= 0 && (!*best || c.estimated_error < (*best)->counters.estimated_error))
                *best = complete;
            iterations.push_back(c);
            progress.show(c);
        }
    } catch (const Cancelled &) {
        solver.restore(complete);
    }
    return iterations;
}

} // namespace penumbra
