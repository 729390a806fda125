// The shelf of hard cases as the window knows it.
#pragma once

#include "study/measurement.h"

#include <array>
#include <string>
#include <vector>

namespace penumbra {

enum class CaseStatus { not_run, running, ok, failed };

/// Of one case in one basis.
struct CaseVerdict {
    CaseStatus status = CaseStatus::not_run;
    std::vector<Measurement> measurements;
    std::string trouble; ///< why nothing was measured; empty: it was
    double seconds = 0;
};

struct ShelfCase {
    std::string name, what;
    std::array<CaseVerdict, 2> verdicts; ///< by basis family
};

struct Shelf {
    std::vector<ShelfCase> cases; ///< filled when it is first opened
    bool checking = false;
    bool check_request = false, stop_request = false; ///< asked of the window; it does them and takes them back
};

} // namespace penumbra
