#include "price_book.h"

#include <utility>

namespace penumbra {

namespace {

bool same_options(const Options &a, const Options &b) {
    return a.strategy == b.strategy && a.basis == b.basis && a.order == b.order && a.tolerance == b.tolerance &&
           (a.tolerance || a.threshold == b.threshold) && a.max_depth == b.max_depth && a.cut == b.cut && a.gather == b.gather &&
           a.coarse_correction == b.coarse_correction && a.max_iterations == b.max_iterations;
}

} // namespace

std::vector<PricedState> priced_states(const Timeline &timeline) {
    std::vector<PricedState> states;
    for (int p = phases_per_iteration; p <= timeline.last(); p += phases_per_iteration) {
        const Snapshot &s = *timeline.moments[static_cast<std::size_t>(p)];
        const PricedState state{s.options, p, s.counters, s.error};
        if (state.error() > 0)
            states.push_back(state);
    }
    return states;
}

void PriceBook::keep(const Timeline &timeline) {
    PricedRun run = priced_states(timeline);
    if (run.empty())
        return;
    std::erase_if(runs, [&](const PricedRun &old) { return same_options(old.back().options, run.back().options); });
    runs.push_back(std::move(run));
}

} // namespace penumbra
