#include "files/paper_table.h"

#include "plot/cost_measure.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace penumbra {

int paper_patches(Strategy strategy) {
    switch (strategy) {
    case Strategy::uniform_constant:
        return 1776;
    case Strategy::discontinuity_constant:
        return 1019;
    case Strategy::uniform_wavelet:
        return 262;
    case Strategy::discontinuity_wavelet:
        return 3;
    }
    return 0;
}

std::string paper_csv(const Solutions &solutions) {
    std::string csv = "strategy,patches,paper_patches,coefficients,links,kernel_evaluations,seconds,error,iterations,clips,"
                      "sampled_visibility,threshold,max_depth,link_coefficients\n";
    for (const auto &s : solutions) {
        const Counters &c = s->counters;
        csv += fmt::format("{},{},{},{},{},{},{:.6g},{},{},{},{},{:.6g},{},{}\n", name(s->options.strategy), c.patches,
                           paper_patches(s->options.strategy), c.coefficients, c.links, c.total_work.kernel_evaluations,
                           c.seconds, s->error >= 0 ? fmt::format("{:.6g}", s->error) : "", c.iteration,
                           c.total_work.clips, c.total_work.sampled_visibility, s->options.threshold,
                           s->options.max_depth, c.link_coefficients);
    }
    return csv;
}

namespace {

constexpr CostMeasure bar_measures[] = {CostMeasure::patches, CostMeasure::coefficients, CostMeasure::link_coefficients,
                                        CostMeasure::seconds};
constexpr int longest_bar = 11; // characters

std::string bar(double share) {
    std::string text;
    for (int i = 0; i < std::max(1, static_cast<int>(std::lround(longest_bar * share))); ++i)
        text += "\u2588";
    return text;
}

std::string number(CostMeasure measure, const Counters &c) {
    return measure == CostMeasure::seconds ? fmt::format("{:.3f}", c.seconds) : fmt::format("{:.0f}", value(measure, c));
}

} // namespace

std::string work_bars(const Solutions &solutions) {
    constexpr int width = longest_bar + 11;
    std::string text = fmt::format("{:4}", "");
    for (const CostMeasure m : bar_measures)
        text += fmt::format(" {:<{}}", m == CostMeasure::coefficients ? "patches \u00d7 functions" : title(m), width);
    text += "\n";
    for (const auto &s : solutions) {
        text += fmt::format("({}) ", "abcd"[static_cast<int>(s->options.strategy)]);
        for (const CostMeasure m : bar_measures) {
            double most = 0;
            for (const auto &other : solutions)
                most = std::max(most, value(m, other->counters));
            text += fmt::format(" {:<{}}", bar(most > 0 ? value(m, s->counters) / most : 0) + " " + number(m, s->counters),
                                width);
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += "\n";
    }
    return text;
}

std::string paper_text(const Solutions &solutions) {
    constexpr const char *row = "{:<4} {:<39} {:>8} {:>8} {:>12} {:>8} {:>12} {:>9} {:>9}\n";
    std::string text = fmt::format(row, "", "strategy", "patches", "paper", "coefficients", "links", "kernel ev.",
                                   "seconds", "error");
    for (const auto &s : solutions) {
        const Counters &c = s->counters;
        text += fmt::format(row, fmt::format("({})", "abcd"[static_cast<int>(s->options.strategy)]),
                            title(s->options.strategy), c.patches, paper_patches(s->options.strategy), c.coefficients,
                            c.links, c.total_work.kernel_evaluations, fmt::format("{:.3f}", c.seconds),
                            s->error >= 0 ? fmt::format("{:.3g} %", 100 * s->error) : "not known");
    }
    if (!solutions.empty()) {
        const Options &o = solutions.front()->options;
        text += "\nPatches are not work; each bar as a share of the longest in its column. With M = 4 a patch takes up to 16 "
                "times the effort\n(section 5): compare (a) with (c).\n\n" +
                work_bars(solutions);
        text += fmt::format("\nOne threshold for all: {:g} of the largest reflected radiosity; depth limit {}; M = {} "
                            "where the basis is not constant.\npaper: the patches that Bouatouch & Pattanaik (1995, "
                            "section 5) report. error: relative L2, against the exact\ndirect solution. The scene is a "
                            "reconstruction: the paper prints no coordinates.\n",
                            o.threshold, o.max_depth, o.order);
    }
    return text;
}

} // namespace penumbra
