#include "files/record.h"

#include "core/parallel.h"
#include "measure/error_estimate.h"

#include <nlohmann/json.hpp>
#include <sys/resource.h>

namespace penumbra {

namespace {

using Json = nlohmann::ordered_json;

double peak_memory_mib() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024; // Linux counts KiB
}

Json iteration(const Counters &c) {
    return {{"iteration", c.iteration},
            {"patches", c.patches},
            {"coefficients", c.coefficients},
            {"links", c.links},
            {"kernel_evaluations", c.work.kernel_evaluations},
            {"clips", c.work.clips},
            {"rays", c.work.rays},
            {"link_evaluations", c.work.link_evaluations},
            {"refine_s", c.refine_s},
            {"gather_s", c.gather_s},
            {"push_pull_s", c.push_pull_s},
            {"measure_s", c.measure_s},
            {"threshold", c.threshold},
            {"estimated_error", c.estimated_error >= 0 ? Json(c.estimated_error) : Json()},
            {"change", c.change}};
}

Json final_state(const Snapshot *solution) {
    const Counters c = solution ? solution->counters : Counters();
    Json json = {{"converged", c.converged},
                 {"patches", c.patches},
                 {"coefficients", c.coefficients},
                 {"links", c.links},
                 {"link_bytes", c.link_bytes},
                 {"curves", c.curves},
                 {"nodes_at_limit", c.nodes_at_limit},
                 {"sampled_visibility", c.total_work.sampled_visibility},
                 {"kernel_evaluations", c.total_work.kernel_evaluations},
                 {"clips", c.total_work.clips},
                 {"rays", c.total_work.rays},
                 {"link_evaluations", c.total_work.link_evaluations},
                 {"products", c.total_work.products},
                 {"channels", c.channels},
                 {"pairs", c.total_work.pairs},
                 {"traced_pairs", c.total_work.traced_pairs},
                 {"traced_reflectors", c.total_work.traced_reflectors},
                 {"lower_links", c.lower_links},
                 {"snapped_cuts", c.total_work.snapped_cuts},
                 {"left_out_curves", c.total_work.left_out_curves},
                 {"untraced_pairs", c.untraced_pairs},
                 {"seconds", c.seconds},
                 {"peak_memory_mib", peak_memory_mib()},
                 {"error", solution && solution->error >= 0 ? Json(solution->error) : Json()},
                 {"estimated_error", c.estimated_error >= 0 ? Json(c.estimated_error) : Json()},
                 {"error_bound", c.error_bound >= 0 ? Json(c.error_bound) : Json()},
                 {"confidence", c.error_bound >= 0 ? Json(ErrorEstimate::confidence) : Json()}};
    if (!solution)
        for (auto &[key, value] : json.items())
            value = key == "converged" ? Json(false) : Json();
    return json;
}

/// By public name; saved and done in the effect's unit.
Json effects(const Snapshot &solution) {
    Json all = Json::array();
    for (const LedgerEntry &e : solution.effects)
        all.push_back({{"name", name(e.effect)},
                       {"decision", name(e.decision)},
                       {"reason", e.reason},
                       {"saved", e.saved},
                       {"done", e.done},
                       {"unit", unit(e.effect)}});
    return all;
}

Json diagnostics(const std::optional<Health> &health) {
    if (!health)
        return nullptr;
    return {{"energy_balance_error", health->energy_balance_error},
            {"min_radiosity", health->min_radiosity},
            {"max_filter_condition", health->max_filter_condition},
            {"non_finite", health->non_finite}};
}

} // namespace

std::string to_json(const Record &record) {
    const Snapshot *solution = record.solution.get();
    Json iterations = Json::array();
    for (const Counters &c : record.iterations)
        iterations.push_back(iteration(c));
    const Json json = {{"scene", record.scene},
                       {"strategy", name(record.options.strategy)},
                       {"basis", name(record.options.basis)},
                       {"order", record.options.effective_order()},
                       {"cut", name(record.options.cut)},
                       {"coarse_correction", name(record.options.coarse_correction)},
                       {"gather", name(record.options.gather)},
                       {"threshold", solution ? solution->counters.threshold : record.options.threshold},
                       {"tolerance", record.options.tolerance.value_or(0) > 0 ? Json(*record.options.tolerance) : Json()},
                       {"threads", threads()},
                       {"version", PENUMBRA_VERSION},
                       {"iterations", std::move(iterations)},
                       {"final", final_state(solution)},
                       {"predicted_seconds", record.predicted_seconds ? Json(*record.predicted_seconds) : Json()},
                       {"stopped_by", record.stopped_by.empty() ? Json() : Json(record.stopped_by)},
                       {"effects", solution ? effects(*solution) : Json()},
                       {"diagnostics", diagnostics(record.health)}};
    // Scene names are bytes that need not be UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace penumbra
