// effects_table [--scenes A,B] [--tolerance X] [--repeats N]: what is spared where only the effects are simulated that a
// scene calls for. Each bundled scene to a tolerance by the default strategy, with every effect's switch on `auto` and on
// `on`, by turns; medians of seconds, and the work of the two. A table in Markdown; exit status 1 when `auto` misses its
// tolerance, does more counted work in all, or takes more than 3 % longer where that can be told (a second and more).
#include "solved.h"

#include "core/machine.h"
#include "core/parallel.h"
#include "iteration/state.h"
#include "study/spread.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

using namespace penumbra;

namespace {

struct Count {
    const char *name;
    std::int64_t (*of)(const Counters &);
};

constexpr std::array counts{
    Count{"kernel evaluations", [](const Counters &c) { return c.total_work.kernel_evaluations; }},
    Count{"clips", [](const Counters &c) { return c.total_work.clips; }},
    Count{"rays", [](const Counters &c) { return c.total_work.rays; }},
    Count{"pairs", [](const Counters &c) { return c.total_work.pairs; }},
    Count{"traced pairs", [](const Counters &c) { return c.total_work.traced_pairs; }},
    Count{"traced reflectors", [](const Counters &c) { return c.total_work.traced_reflectors; }},
    Count{"products", [](const Counters &c) { return c.total_work.products; }}};

struct Run {
    Counters counters;
    double seconds = 0; ///< median
    double error = 0;
};

/// The first time also measures the error.
double solve(const std::shared_ptr<const Scene> &scene, const Options &options, const TrueError &error, Run &run) {
    Solver solver(scene, options);
    solver.run();
    if (run.counters.iteration == 0)
        run.error = error(*solver.state());
    run.counters = solver.counters();
    return run.counters.seconds;
}

struct Verdicts {
    int n = 0, delivered = 0, no_more_work = 0, no_more_of_any = 0, long_ones = 0, in_time = 0;
    std::vector<double> gains;
};

std::string ratio(std::int64_t more, std::int64_t less) {
    char text[32];
    if (less == 0)
        return more == 0 ? "–" : "all";
    std::snprintf(text, sizeof text, "%.2f", static_cast<double>(more) / static_cast<double>(less));
    return text;
}

void add_row(const std::string &name, double tolerance, int repeats, Verdicts &verdicts) {
    const auto scene = bundled(name.c_str());
    Options plain = Options().to_tolerance(tolerance), whole = plain;
    for (const Effect e : all_effects)
        whole.effects[e] = Switch::on;
    const TrueError error = true_error(scene, 0.3 * tolerance);
    Run of_plain, of_whole;
    std::vector<double> plain_seconds, whole_seconds;
    for (int i = 0; i < repeats; ++i) {
        plain_seconds.push_back(solve(scene, plain, error, of_plain));
        whole_seconds.push_back(solve(scene, whole, error, of_whole));
    }
    of_plain.seconds = spread_of(plain_seconds).median;
    of_whole.seconds = spread_of(whole_seconds).median;
    const double gain = of_plain.seconds > 0 ? of_whole.seconds / of_plain.seconds : 1;
    std::string more;
    std::int64_t all_done = 0, all_whole = 0;
    std::printf("| %s | %.3f | %.3f | %.2f |", name.c_str(), of_plain.seconds, of_whole.seconds, gain);
    for (const Count &count : counts) {
        const std::int64_t done = count.of(of_plain.counters), all = count.of(of_whole.counters);
        std::printf(" %s |", ratio(all, done).c_str());
        all_done += done;
        all_whole += all;
        if (done > all)
            more += (more.empty() ? "" : ", ") + std::string(count.name);
    }
    std::printf(" %s | %.2g, %.2g | %s |\n", ratio(all_whole, all_done).c_str(), of_plain.error, of_whole.error, more.c_str());
    std::fflush(stdout);
    ++verdicts.n;
    verdicts.delivered += of_plain.error <= tolerance;
    verdicts.no_more_work += all_done <= all_whole;
    verdicts.no_more_of_any += more.empty();
    if (of_whole.seconds >= 1) {
        ++verdicts.long_ones;
        verdicts.in_time += of_plain.seconds <= 1.03 * of_whole.seconds;
    }
    verdicts.gains.push_back(gain);
}

} // namespace

int main(int argc, char **argv) {
    std::vector<std::string> scenes;
    for (const BundledScene &s : bundled_scenes())
        scenes.emplace_back(s.name);
    double tolerance = 0.01;
    int repeats = 5;
    CLI::App options("What is spared by simulating only what a scene calls for");
    options.add_option("--scenes", scenes)->delimiter(',');
    options.add_option("--tolerance", tolerance);
    options.add_option("--repeats", repeats)->check(CLI::PositiveNumber);
    CLI11_PARSE(options, argc, argv);
    std::printf("%s, %d threads, tolerance %g\n\n| scene | auto [s] | all on [s] | gain |", cpu_model().c_str(), threads(), tolerance);
    for (const Count &count : counts)
        std::printf(" %s |", count.name);
    std::printf(" sum | errors | more than all on |\n| --- | ---: | ---: | ---: |");
    for (std::size_t i = 0; i < counts.size(); ++i)
        std::printf(" ---: |");
    std::printf(" ---: | ---: | --- |\n");
    Verdicts v;
    for (const std::string &scene : scenes)
        add_row(scene, tolerance, repeats, v);
    std::printf("\n%d scenes: %d delivered, %d without more counted work, %d of any kind, %d of %d longer than a second within 3 %%; median gain %.2f\n",
                v.n, v.delivered, v.no_more_work, v.no_more_of_any, v.in_time, v.long_ones, spread_of(v.gains).median);
    return v.delivered == v.n && v.no_more_work == v.n && v.in_time == v.long_ones ? 0 : 1;
}
