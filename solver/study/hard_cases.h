// The shelf of hard cases: small scenes in which solvers lose digits, each with what must hold.
#pragma once

#include "study/trial.h"

#include <functional>
#include <string>
#include <vector>

namespace penumbra {

struct HardCase {
    std::string name; ///< as people call it: `edge-10-degrees`
    std::string what; ///< what must hold, in a sentence
    std::function<std::vector<Measurement>(const TrialSetting &)> measure;
};

/// All of them, in the order of the shelf. tests/stability/hard_cases_test.cpp runs each in both bases.
std::vector<HardCase> hard_cases();

/// What a case is about, to be looked at: the first scene that it solves, under the case's name. Solves nothing.
Scene scene_of(const HardCase &hard_case);

struct CaseResult {
    std::string name, what;
    BasisFamily basis = BasisFamily::parametric;
    std::vector<Measurement> measurements;

    /// Something was measured, and all of it holds.
    bool holds() const;
};

/// Whether a check may pass: there are results, and each holds.
bool all_hold(const std::vector<CaseResult> &results);

/// Solves with the options that `solve` has unless told otherwise; `threads`: as Options has them. Throws Cancelled.
CaseResult examine(const HardCase &hard_case, BasisFamily basis, const Cancel *cancel = nullptr, int threads = 0);

} // namespace penumbra
