#include "plot/cost_measure.h"

#include <array>

namespace penumbra {

namespace {

struct Description {
    std::string_view name, title, sentence;
};
constexpr std::array<Description, 5> descriptions{{
    {"seconds", "seconds", "Time of all iterations so far."},
    {"patches", "patches", "Leaves of the surfaces that reflect. A patch is not a unit of work: with M = 4 it may take 16 times the "
                           "effort of a constant one."},
    {"coefficients", "coefficients", "Patches times functions: basis functions on all patches: one for a constant patch, up to M\u00b2 for others."},
    {"link_coefficients", "links \u00d7 coefficients",
     "Transport coefficients of all links, which each iteration multiplies with: one between two constants, up to M\u2074 "
     "between others."},
    {"kernel_evaluations", "kernel evaluations", "Times that two points, or a point and a polygon, were asked what light goes from one to the other."},
}};

const Description &of(CostMeasure measure) { return descriptions[static_cast<std::size_t>(measure)]; }

} // namespace

std::string_view name(CostMeasure measure) { return of(measure).name; }

std::optional<CostMeasure> cost_measure_from_name(std::string_view text) {
    for (const CostMeasure m : all_cost_measures)
        if (name(m) == text)
            return m;
    return std::nullopt;
}

std::string_view title(CostMeasure measure) { return of(measure).title; }

std::string_view sentence(CostMeasure measure) { return of(measure).sentence; }

PlotUnit unit(CostMeasure measure) { return measure == CostMeasure::seconds ? PlotUnit::seconds : PlotUnit::count; }

double value(CostMeasure measure, const Counters &c) {
    switch (measure) {
    case CostMeasure::seconds:
        return c.seconds;
    case CostMeasure::patches:
        return c.patches;
    case CostMeasure::coefficients:
        return static_cast<double>(c.coefficients);
    case CostMeasure::link_coefficients:
        return static_cast<double>(c.link_coefficients);
    case CostMeasure::kernel_evaluations:
        break;
    }
    return static_cast<double>(c.total_work.kernel_evaluations);
}

} // namespace penumbra
