// A flag that any thread may raise; long work looks at it every few milliseconds.
#pragma once

#include "core/error.h"

#include <atomic>

namespace penumbra {

class Cancel {
public:
    void raise() { raised_.store(true, std::memory_order_relaxed); }
    void lower() { raised_.store(false, std::memory_order_relaxed); }
    bool raised() const { return raised_.load(std::memory_order_relaxed); }
    /// Throws Cancelled when the flag is up.
    void check() const {
        if (raised())
            throw Cancelled();
    }

private:
    std::atomic<bool> raised_{false};
};

} // namespace penumbra
