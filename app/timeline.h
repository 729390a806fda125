// The course of a solution, counted in phases: position 0 is the start; refine, gather and push-pull of iteration k are
// the positions 3(k-1)+1, 3(k-1)+2 and 3k. All panes stand at one position, each in its own strategy's timeline.
#pragma once

#include "iteration/snapshot.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace penumbra {

inline constexpr int phases_per_iteration = 3;

/// The iteration that a position belongs to; 0 at the start.
constexpr int iteration_of(int position) { return (position + phases_per_iteration - 1) / phases_per_iteration; }

constexpr Phase phase_of(int position) {
    if (position == 0)
        return Phase::start;
    constexpr Phase phases[] = {Phase::refined, Phase::gathered, Phase::pushed_pulled};
    return phases[(position - 1) % phases_per_iteration];
}

/// The reverse of both.
constexpr int position_of(int iteration, Phase phase) {
    return phase == Phase::start ? 0 : phases_per_iteration * (iteration - 1) + static_cast<int>(phase);
}

/// The end of an iteration.
constexpr int step_position(int iteration) { return phases_per_iteration * iteration; }

/// Where one step forward leads: the end of the present iteration, or of the next where it is complete.
constexpr int step_forward(int position) { return (position / phases_per_iteration + 1) * phases_per_iteration; }

/// Where one step back leads: the end of the iteration before; never below the start.
constexpr int step_back(int position) {
    return std::max(0, (position - 1) / phases_per_iteration * phases_per_iteration);
}

/// A position, and within a refinement the number of its splits, or of its pairs linked after all splits, that are shown.
struct Place {
    int position = 0;
    std::optional<int> split{}, linking{}; ///< none: all

    bool operator==(const Place &) const = default;
};

/// What one strategy has computed so far.
struct Timeline {
    std::vector<std::shared_ptr<const Snapshot>> moments; ///< by position
    bool ended = false; ///< converged, failed, or at the last iteration allowed: no moment will follow

    int last() const { return static_cast<int>(moments.size()) - 1; } ///< -1 before anything is known
    bool reached(int position) const { return ended || last() >= position; }
    /// The snapshot at a position, or the last one where the course ends sooner; null before anything is known.
    std::shared_ptr<const Snapshot> at(int position) const {
        return moments.empty() ? nullptr : moments[static_cast<std::size_t>(std::clamp(position, 0, last()))];
    }
};

} // namespace penumbra
