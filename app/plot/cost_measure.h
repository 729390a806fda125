// The measures by which a solution's price can be told: patches alone are not work.
#pragma once

#include "core/counters.h"
#include "plot/log_axis.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace penumbra {

enum class CostMeasure { seconds, patches, coefficients, link_coefficients, kernel_evaluations };

inline constexpr CostMeasure all_cost_measures[] = {CostMeasure::seconds, CostMeasure::patches, CostMeasure::coefficients,
                                                    CostMeasure::link_coefficients, CostMeasure::kernel_evaluations};

/// `seconds`, `patches`, `coefficients`, `link_coefficients`, `kernel_evaluations`; names it to files and tests.
std::string_view name(CostMeasure measure);
std::optional<CostMeasure> cost_measure_from_name(std::string_view name);
/// In words, for axes: "kernel evaluations".
std::string_view title(CostMeasure measure);
/// What it counts, in a plain sentence.
std::string_view sentence(CostMeasure measure);
PlotUnit unit(CostMeasure measure);
/// [s], or a count.
double value(CostMeasure measure, const Counters &counters);

} // namespace penumbra
