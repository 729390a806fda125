// What was decided about each effect, why, and what that saved.
#pragma once

#include "core/counters.h"
#include "core/options.h"
#include "effects/plan.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

enum class Decision { on, off, partial };
/// `on`, `off`, `partial`; the public names.
std::string_view name(Decision decision);

struct LedgerEntry {
    Effect effect;
    Decision decision = Decision::on;
    std::string reason;     ///< a sentence with figures
    /// Work that was not done and would have been done with the effect's switch on, in its unit. A count of what was left out
    /// where it was left out.
    std::int64_t saved = 0;
    std::int64_t done = 0;  ///< work of that unit that was done
};

/// By effect, in the order of `all_effects`. On: all work was done; off: none, since nothing calls for it or somebody said so;
/// partial: some was left out. Before the first step, as far as the plan tells.
std::vector<LedgerEntry> ledger(const Scene &scene, const Options &options, const Plan &plan, const Counters &counters);

} // namespace penumbra
