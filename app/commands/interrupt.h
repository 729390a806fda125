// What may end a solution early: Ctrl+C, a polite kill, the time limit, the memory limit.
#pragma once

#include "core/cancel.h"

#include <optional>
#include <string>
#include <thread>

namespace penumbra {

struct Limits {
    std::optional<double> seconds;
    /// Of resident memory, see core/resident_memory.h [MiB]. Looked at every 10 ms, so that it may be passed by what is
    /// allocated in that time and until the step is left (100 ms).
    std::optional<double> memory_mib;
};

/// While it lives, the first SIGINT or SIGTERM raises cancel() in place of ending the program; a second one ends it.
/// One at a time.
class Interrupt {
public:
    /// Raises cancel() also when a limit is met.
    explicit Interrupt(const Limits &limits = {});
    ~Interrupt();
    Interrupt(const Interrupt &) = delete;
    Interrupt &operator=(const Interrupt &) = delete;

    const Cancel &cancel() const;
    /// The limits no longer hold, nor did they while what came before was finished.
    void lift_limits();
    /// 130 or 143 after a signal, 4 after a limit, else 0.
    int exit_status() const;
    /// What it was, as records have it: "interrupt", "time limit", "memory limit"; empty: nothing yet.
    std::string cause() const;
    /// The same as the beginning of a sentence: "interrupted", "the time limit of 2 s stopped it".
    std::string sentence() const;

private:
    Limits limits_;
    std::jthread watch_;
};

} // namespace penumbra
