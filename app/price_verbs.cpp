#include "price_verbs.h"

#include "iteration/solver.h"
#include "pane_verbs.h"
#include "verbs.h"

#include <algorithm>

namespace penumbra {

namespace {

/// What was paid with the one says something about the other.
bool differ_in_accuracy_alone(const Options &a, const Options &b) {
    return a.strategy == b.strategy && a.basis == b.basis && a.effective_order() == b.effective_order() && a.cut == b.cut &&
           a.gather == b.gather && a.coarse_correction == b.coarse_correction && a.threads == b.threads;
}

} // namespace

std::vector<LiveRun> live_runs(const AppState &state) {
    std::vector<LiveRun> runs;
    for (const Strategy s : all_strategies) {
        const Timeline &timeline = state.timeline(s);
        int here = -1;
        for (int pane = n_panes(state.layout) - 1; pane >= 0; --pane)
            if (state.strategy_of(pane) == s && (here < 0 || pane == state.panes().active))
                here = std::min(state.asked_position(pane), timeline.last());
        LiveRun run{priced_states(timeline), here, false};
        if (!run.states.empty())
            runs.push_back(std::move(run));
    }
    for (const PricedRun &earlier : state.prices.runs)
        runs.push_back({{earlier.back()}, -1, true});
    return runs;
}

void go_to_priced(AppState &state, const PricedState &priced, bool earlier) {
    state.playing = false;
    if (earlier) {
        Options options = priced.options;
        options.threads = state.options.threads;
        state.asked_tolerance = options.tolerance.value_or(state.asked_tolerance);
        set_options(state, options);
    }
    const std::vector<Strategy> shown = state.shown();
    const auto pane = std::ranges::find(shown, priced.options.strategy);
    if (pane == shown.end())
        set_strategy(state, priced.options.strategy);
    else
        activate(state, static_cast<int>(pane - shown.begin()));
    go_to(state, priced.position);
}

std::optional<Price> price_tag(const AppState &state, Strategy strategy, double tolerance) {
    if (!state.scene)
        return std::nullopt;
    Options options = state.options;
    options.strategy = strategy;
    std::vector<PricePaid> paid, paid_by_threshold;
    const auto add = [&](const PricedRun &run) {
        for (const PricedState &s : run)
            if (differ_in_accuracy_alone(s.options, options))
                if (const auto p = price_paid(s.options, s.counters, s.true_error))
                    (s.options.tolerance ? paid : paid_by_threshold).push_back(*p);
    };
    for (const PricedRun &run : state.prices.runs)
        add(run);
    add(priced_states(state.timeline(strategy)));
    // A tolerance costs more than the same error found by luck with a threshold.
    return predict_price(paid.empty() ? paid_by_threshold : paid, usual_growth(options, has_one_bounce(*state.scene)),
                         tolerance);
}

void ask_for_tolerance(AppState &state, const Options &options) {
    std::array<std::optional<Price>, 4> predicted;
    for (const Strategy s : all_strategies)
        predicted[static_cast<std::size_t>(s)] = price_tag(state, s, *options.tolerance);
    start_again(state, options);
    state.prices.predicted = predicted;
}

std::vector<std::shared_ptr<const Snapshot>> compared(const AppState &state) {
    std::vector<std::shared_ptr<const Snapshot>> snapshots;
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        if (auto snapshot = state.solution(pane))
            snapshots.push_back(std::move(snapshot));
    return snapshots;
}

} // namespace penumbra
