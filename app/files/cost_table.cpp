#include "files/cost_table.h"

#include "study/spread.h"

#include <fmt/format.h>

namespace penumbra {

namespace {

std::string quoted(const std::string &field) {
    if (field.find_first_of(",\"\r\n") == std::string::npos)
        return field;
    std::string text = "\"";
    for (const char c : field)
        text += c == '"' ? "\"\"" : std::string(1, c);
    return text + '"';
}

std::string seconds_fields(const CostPoint &point) {
    if (point.seconds.empty())
        return ",,";
    const Spread s = spread_of(point.seconds);
    return fmt::format("{:.6g},{:.6g},{:.6g}", s.median, s.low, s.high);
}

std::string counter_fields(const CostPoint &point) {
    const Counters &c = point.counters;
    if (c.iteration == 0)
        return ",,,,,,,";
    return fmt::format("{},{},{},{},{},{},{},{}", c.patches, c.coefficients, c.links, c.total_work.kernel_evaluations,
                       point.error >= 0 ? fmt::format("{:.6g}", point.error) : "", c.iteration, c.total_work.clips,
                       c.nodes_at_limit);
}

} // namespace

std::string cost_csv(const CostStudy &study) {
    std::string csv = "strategy,basis,order,threshold,max_depth,status,runs,seconds,seconds_min,seconds_max,patches,"
                      "coefficients,links,kernel_evaluations,error,iterations,clips,nodes_at_limit,scene,cpu,cores,"
                      "threads,version,reference_error\n";
    for (const CostPoint &p : study.points)
        csv += fmt::format("{},{},{},{:.6g},{},{},{},{},{},{},{},{},{},{},{:.2g}\n", name(p.options.strategy),
                           name(p.options.basis), p.options.effective_order(), p.options.threshold,
                           p.options.max_depth, name(p.end), p.n_runs(), seconds_fields(p), counter_fields(p),
                           quoted(study.scene), quoted(study.cpu), study.cores, study.threads, study.version,
                           study.reference_error);
    return csv;
}

} // namespace penumbra
