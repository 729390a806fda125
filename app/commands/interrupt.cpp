#include "commands/interrupt.h"

#include "commands/command.h"

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>

namespace penumbra {

namespace {

// A signal handler can reach nothing but static, lock-free state.
Cancel cancelled;
std::atomic<int> signal_seen{0};
std::atomic<bool> time_is_up{false};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void on_signal(int signal) {
    signal_seen = signal;
    cancelled.raise();
    std::signal(signal, SIG_DFL);
}

/// Sleeps until the limit or until asked to stop.
void watch(const std::stop_token &stop, double seconds) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any asleep;
    asleep.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
    if (!stop.stop_requested()) {
        time_is_up = true;
        cancelled.raise();
    }
}

} // namespace

Interrupt::Interrupt(std::optional<double> time_limit) {
    cancelled.lower();
    signal_seen = 0;
    time_is_up = false;
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    if (time_limit)
        clock_ = std::jthread([seconds = *time_limit](const std::stop_token &stop) { watch(stop, seconds); });
}

Interrupt::~Interrupt() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

const Cancel &Interrupt::cancel() const { return cancelled; }

int Interrupt::exit_status() const {
    if (signal_seen != 0)
        return 128 + signal_seen;
    return time_is_up ? not_reached : done;
}

} // namespace penumbra
