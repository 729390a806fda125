#include "study/cost.h"

#include "core/resident_memory.h"
#include "iteration/solver.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <new>
#include <numeric>
#include <optional>
#include <random>
#include <utility>

namespace penumbra {

namespace {

using Steady = std::chrono::steady_clock;

double seconds_since(Steady::time_point start) {
    return std::chrono::duration<double>(Steady::now() - start).count();
}

/// std::shuffle's order is not the same everywhere.
void shuffle(std::vector<std::size_t> &order, std::mt19937 &random) {
    for (std::size_t n = order.size(); n > 1; --n)
        std::swap(order[n - 1], order[random() % n]);
}

std::vector<std::size_t> shuffled(std::size_t n, std::mt19937 &random) {
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    shuffle(order, random);
    return order;
}

std::vector<CostPoint> points_of(const CostRange &range, const std::vector<double> &thresholds) {
    std::vector<CostPoint> points;
    for (const Strategy strategy : range.strategies)
        for (const BasisFamily basis : range.bases)
            for (const double threshold : thresholds) {
                CostPoint point;
                point.options = range.options;
                point.options.strategy = strategy;
                point.options.basis = basis;
                point.options.threshold = threshold;
                points.push_back(std::move(point));
            }
    return points;
}

void take_first(CostPoint &point, const CostRun &run) {
    point.end = run.end;
    point.counters = run.counters;
    point.error = run.error;
    point.trouble = run.trouble;
    point.seconds = {run.seconds};
}

} // namespace

std::string_view name(RunEnd end) {
    constexpr std::string_view names[] = {"done",   "not converged", "time limit", "memory limit",
                                          "failed", "not tried",     "interrupted"};
    return names[static_cast<std::size_t>(end)];
}

CostRunner solving_runner(std::shared_ptr<const Scene> scene, TrueError error, const RunLimits &limits,
                          const Cancel &cancel) {
    return [=, &cancel](const Options &options, int repeat) {
        give_back_memory(); // what earlier runs have freed is not this one's
        RunLimits own = limits;
        if (own.seconds && repeat > 0)
            *own.seconds *= 4;
        CostRun run;
        std::optional<Solver> solver;
        double prepared = 0;
        const auto start = Steady::now();
        {
            const RunWatch watch(own, cancel);
            try {
                solver.emplace(scene, options, &watch.cancel());
                prepared = seconds_since(start);
                run.end = solver->run(&watch.cancel()) ? RunEnd::done : RunEnd::not_converged;
            } catch (const Cancelled &) {
                if (cancel.raised())
                    throw;
                run.end = watch.met() == RunWatch::Met::memory ? RunEnd::memory_limit : RunEnd::time_limit;
            } catch (const std::bad_alloc &) {
                run.end = RunEnd::failed;
                run.trouble = "out of memory";
            } catch (const std::exception &e) {
                run.end = RunEnd::failed;
                run.trouble = e.what();
            }
        }
        run.seconds = seconds_since(start) - (cuts_along_curves(options.strategy) ? 0 : prepared);
        if (!solver)
            return run;
        run.counters = solver->counters();
        if (error && repeat == 0 && run.counters.iteration > 0)
            run.error = error(*solver->state());
        cancel.check();
        return run;
    };
}

std::vector<CostPoint> measure_cost(const CostRange &range, const CostRunner &run, const CostProgress &told) {
    std::vector<double> thresholds = range.thresholds;
    std::ranges::sort(thresholds, std::greater<>());
    thresholds.erase(std::ranges::unique(thresholds).begin(), thresholds.end());
    std::vector<CostPoint> points = points_of(range, thresholds);
    if (points.empty())
        return points;
    int done = 0, all = static_cast<int>(points.size()) * range.repeats;
    const auto tell = [&](const CostPoint &point) {
        ++done;
        if (told)
            told(point, done, all);
    };
    std::mt19937 random(1995);
    const std::size_t n_thresholds = thresholds.size();
    try {
        run(points.front().options, 1);
        for (const std::size_t curve : shuffled(points.size() / n_thresholds, random))
            for (std::size_t t = 0; t < n_thresholds; ++t) {
                CostPoint &point = points[curve * n_thresholds + t];
                take_first(point, run(point.options, 0));
                if (!point.done())
                    all -= static_cast<int>(n_thresholds - t - 1) * range.repeats + range.repeats - 1;
                tell(point);
                if (!point.done())
                    break;
            }
        std::vector<std::size_t> again;
        for (const std::size_t i : shuffled(points.size() * static_cast<std::size_t>(range.repeats - 1), random))
            again.push_back(i % points.size());
        for (const std::size_t i : again) {
            if (!points[i].done())
                continue;
            const CostRun repeat = run(points[i].options, 1);
            if (repeat.end == RunEnd::done)
                points[i].seconds.push_back(repeat.seconds);
            tell(points[i]);
        }
    } catch (const Cancelled &) {
        // A curve that had met a limit is told apart from one that nobody came to.
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool stopped = i % n_thresholds > 0 && points[i - 1].end != RunEnd::done &&
                                 points[i - 1].end != RunEnd::interrupted;
            if (points[i].end == RunEnd::not_tried && !stopped)
                points[i].end = RunEnd::interrupted;
        }
    }
    return points;
}

} // namespace penumbra
