// Ends one run of many when it has taken too much, and leaves the others alone.
#pragma once

#include "core/cancel.h"

#include <atomic>
#include <optional>
#include <thread>

namespace penumbra {

struct RunLimits {
    std::optional<double> seconds;    ///< of one run, wall clock
    std::optional<double> memory_mib; ///< resident memory of the whole program [MiB]
};

/// From its making on raises cancel() when a limit is met or `all` is raised; looks every 5 ms.
class RunWatch {
public:
    enum class Met { nothing, time, memory };

    RunWatch(const RunLimits &limits, const Cancel &all);
    RunWatch(const RunWatch &) = delete;
    RunWatch &operator=(const RunWatch &) = delete;

    const Cancel &cancel() const { return cancel_; }
    /// The limit that raised cancel().
    Met met() const { return met_; }

private:
    Cancel cancel_;
    std::atomic<Met> met_{Met::nothing};
    std::jthread thread_; ///< last: it uses the above
};

} // namespace penumbra
