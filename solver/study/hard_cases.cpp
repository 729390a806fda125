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

Scene scene_of(const HardCase &hard_case) {
    struct Found {
        Faces faces;
    };
    TrialSetting setting;
    setting.on_solve = [](const Faces &faces) { throw Found{faces}; };
    try {
        hard_case.measure(setting);
    } catch (const Found &found) {
        return build_scene(found.faces, hard_case.name);
    }
    throw BadInput(hard_case.name + ": the case solves no scene of faces; there is nothing to show");
}

bool CaseResult::holds() const {
    return !measurements.empty() && std::ranges::all_of(measurements, &Measurement::holds);
}

bool all_hold(const std::vector<CaseResult> &results) {
    return !results.empty() && std::ranges::all_of(results, &CaseResult::holds);
}

CaseResult examine(const HardCase &hard_case, BasisFamily basis, const Cancel *cancel, int threads) {
    TrialSetting setting;
    setting.cancel = cancel;
    setting.options.basis = basis;
    setting.options.threads = threads;
    return {hard_case.name, hard_case.what, basis, hard_case.measure(setting)};
}

} // namespace penumbra
