#include "study/hard_cases.h"

#include "study/case_groups.h"

#include <algorithm>
#include <iterator>

namespace penumbra {

std::vector<HardCase> hard_cases() {
    std::vector<HardCase> shelf;
    for (const auto &group : {touching_cases, blocker_cases, shape_cases, cutting_cases, moved_cases, closed_room_cases})
        std::ranges::move(group(), std::back_inserter(shelf));
    return shelf;
}

bool CaseResult::holds() const {
    return !measurements.empty() && std::ranges::all_of(measurements, &Measurement::holds);
}

bool all_hold(const std::vector<CaseResult> &results) {
    return !results.empty() && std::ranges::all_of(results, &CaseResult::holds);
}

CaseResult examine(const HardCase &hard_case, BasisFamily basis, const Cancel *cancel) {
    TrialSetting setting;
    setting.cancel = cancel;
    setting.options.basis = basis;
    return {hard_case.name, hard_case.what, basis, hard_case.measure(setting)};
}

} // namespace penumbra
