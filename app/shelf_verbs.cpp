#include "shelf_verbs.h"

#include "core/error.h"
#include "verbs.h"

#include <utility>

namespace penumbra {

namespace {

CaseVerdict &verdict(Shelf &shelf, std::size_t index, BasisFamily basis) {
    return shelf.cases[index].verdicts[static_cast<std::size_t>(basis)];
}

void take(Shelf &shelf, const CaseBegun &begun) {
    verdict(shelf, begun.index, begun.basis) = {CaseStatus::running, {}, {}, 0};
}

void take(Shelf &shelf, const CaseExamined &examined) {
    const CaseResult &result = examined.result;
    verdict(shelf, examined.index, result.basis) = {
        result.holds() ? CaseStatus::ok : CaseStatus::failed, result.measurements, {}, examined.seconds};
}

void take(Shelf &shelf, const CaseRefused &refused) {
    verdict(shelf, refused.index, refused.basis) = {CaseStatus::failed, {}, refused.sentence, 0};
}

void take(Shelf &shelf, const CheckEnded &) {
    shelf.checking = false;
    for (ShelfCase &c : shelf.cases)
        for (CaseVerdict &v : c.verdicts)
            if (v.status == CaseStatus::running)
                v = {};
}

std::string sentence(const Shelf &shelf, bool stopped) {
    const int ok = n_verdicts(shelf, CaseStatus::ok), failed = n_verdicts(shelf, CaseStatus::failed);
    return (stopped ? "Stopped: " : "Checked: ") + std::to_string(ok) + " of " + std::to_string(ok + failed) + " hold.";
}

} // namespace

void fill_shelf(AppState &state) {
    if (state.shelf.cases.empty())
        for (const HardCase &hard_case : hard_cases())
            state.shelf.cases.push_back({hard_case.name, hard_case.what, {}});
}

void check_shelf(AppState &state) {
    fill_shelf(state);
    for (ShelfCase &c : state.shelf.cases)
        c.verdicts = {};
    state.shelf.checking = state.shelf.check_request = true;
    state.inspector = Inspector::hard_cases;
}

void stop_check(AppState &state) { state.shelf.stop_request = true; }

void open_case(AppState &state, std::size_t index, std::optional<BasisFamily> basis) {
    try {
        const auto scene = std::make_shared<const Scene>(scene_of(hard_cases().at(index)));
        state.options.basis = basis.value_or(state.options.basis);
        penumbra::apply(state, Report(Opened{{scene, {}}}));
        state.message = {scene->name + ": " + state.shelf.cases[index].what + ".", false};
    } catch (const std::exception &e) {
        state.message = {e.what(), true};
    }
}

void apply(AppState &state, const CheckReport &report) {
    std::visit([&](const auto &r) { take(state.shelf, r); }, report);
    if (const auto *ended = std::get_if<CheckEnded>(&report))
        state.message = {sentence(state.shelf, ended->stopped), false};
}

int n_verdicts(const Shelf &shelf, CaseStatus status) {
    int n = 0;
    for (const ShelfCase &c : shelf.cases)
        for (const CaseVerdict &v : c.verdicts)
            n += v.status == status;
    return n;
}

} // namespace penumbra
