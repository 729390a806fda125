#include "files/check_table.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace penumbra {

namespace {

using Json = nlohmann::ordered_json;

// Scene names are bytes that need not be UTF-8.
std::string dump(const Json &json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

} // namespace

std::string check_text(const std::vector<CaseResult> &results, bool all) {
    constexpr const char *row = "  {:<10} {:<36} {:>10} {:>10}  {}\n";
    std::string text = fmt::format(row, "basis", "quantity", "measured", "bound", ""), last;
    for (const CaseResult &result : results) {
        if (result.name != last)
            text += fmt::format("{}: {}\n", result.name, result.what);
        last = result.name;
        for (const Measurement &m : result.measurements)
            if (all || !m.common || !m.holds())
                text += fmt::format(row, name(result.basis), m.quantity, fmt::format("{:.3g}", m.value),
                                    fmt::format("{:.3g}", m.bound), m.holds() ? "ok" : "FAILED");
    }
    const auto n_failed = std::ranges::count_if(results, [](const CaseResult &r) { return !r.holds(); });
    text +=
        "\nAsked of every case, too: nothing that is not finite, no radiosity further below 0 than the threshold, the\n"
        "fixed point reached (-v shows them).\n";
    text += fmt::format("{} of {} hold\n", static_cast<std::ptrdiff_t>(results.size()) - n_failed, results.size());
    for (const CaseResult &result : results)
        if (!result.holds())
            text += fmt::format("FAILED: {} ({})\n", result.name, name(result.basis));
    return text;
}

std::string check_json(const std::vector<CaseResult> &results) {
    Json list = Json::array();
    for (const CaseResult &result : results) {
        Json measurements = Json::array();
        for (const Measurement &m : result.measurements)
            measurements.push_back(
                {{"quantity", m.quantity}, {"value", finite(m.value)}, {"bound", m.bound}, {"holds", m.holds()}});
        list.push_back({{"name", result.name},
                        {"what", result.what},
                        {"basis", name(result.basis)},
                        {"holds", result.holds()},
                        {"measurements", std::move(measurements)}});
    }
    return dump(list);
}

std::string health_text(const std::vector<SceneHealth> &scenes) {
    constexpr const char *row =
        "{:<{}} {:<10} {:>9} {:>9} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9} {:>10} {:>8} {:>8}  {}\n";
    std::size_t longest = 5;
    for (const SceneHealth &s : scenes)
        longest = std::max(longest, s.scene.size());
    std::string text = fmt::format(row, "scene", longest, "basis", "balance", "absorbed", "lost", "drift", "closure",
                                   "least", "Gram", "condition", "not finite", "links", "at limit", "");
    for (const SceneHealth &s : scenes)
        text += fmt::format(row, s.scene, longest, name(s.basis),
                            fmt::format("{:.3f} %", 100 * s.health.energy_balance_error),
                            fmt::format("{:.1f} %", 100 * s.health.absorbed),
                            fmt::format("{:.1f} %", 100 * s.health.lost),
                            fmt::format("{:.2f} %", 100 * s.health.drift),
                            std::isfinite(s.health.closure_error) ? fmt::format("{:.1e}", s.health.closure_error) : "-",
                            fmt::format("{:.2g}", s.peak > 0 ? s.health.min_radiosity / s.peak : 0.0),
                            fmt::format("{:.1e}", s.health.max_gram_error),
                            fmt::format("{:.3g}", s.health.max_filter_condition), s.health.non_finite, s.counters.links,
                            s.counters.nodes_at_limit, s.counters.converged ? "converged" : "NOT CONVERGED");
    return text +
           "\nbalance: energy that arrives less what independent rays bring, of the emitted, in the worst channel.\n"
           "emitted = absorbed (as solved) + lost (by rays, to black surfaces or out of the scene) + drift. closure: the\n"
           "largest distance of a surface's form factors' sum from 1; - where the scene is open or part of it dark.\n"
           "least: smallest radiosity, of the largest reflected. Gram: how far bases are from orthonormal. condition:\n"
           "largest of a push filter. at limit: nodes whose links failed the oracle at the depth limit.\n";
}

std::string health_json(const std::vector<SceneHealth> &scenes) {
    Json list = Json::array();
    for (const SceneHealth &s : scenes)
        list.push_back({{"scene", s.scene},
                        {"basis", name(s.basis)},
                        {"energy_balance_error", finite(s.health.energy_balance_error)},
                        {"absorbed", finite(s.health.absorbed)},
                        {"lost", finite(s.health.lost)},
                        {"drift", finite(s.health.drift)},
                        {"closure_error", finite(s.health.closure_error)},
                        {"max_gram_error", finite(s.health.max_gram_error)},
                        {"min_radiosity", finite(s.health.min_radiosity)},
                        {"peak", finite(s.peak)},
                        {"max_filter_condition", finite(s.health.max_filter_condition)},
                        {"non_finite", s.health.non_finite},
                        {"links", s.counters.links},
                        {"nodes_at_limit", s.counters.nodes_at_limit},
                        {"converged", s.counters.converged}});
    return dump(list);
}

} // namespace penumbra
