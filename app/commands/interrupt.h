// What may end a solution early: Ctrl+C, a polite kill, the time limit.
#pragma once

#include "core/cancel.h"

#include <optional>
#include <thread>

namespace penumbra {

/// While it lives, the first SIGINT or SIGTERM raises cancel() in place of ending the program; a second one ends it.
/// One at a time.
class Interrupt {
public:
    /// Raises cancel() also when that many seconds have passed.
    explicit Interrupt(std::optional<double> time_limit = std::nullopt);
    ~Interrupt();
    Interrupt(const Interrupt &) = delete;
    Interrupt &operator=(const Interrupt &) = delete;

    const Cancel &cancel() const;
    /// 130 or 143 after a signal, 4 after the time limit, else 0.
    int exit_status() const;

private:
    std::jthread clock_;
};

} // namespace penumbra
