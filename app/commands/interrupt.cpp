#include "commands/interrupt.h"

#include "commands/command.h"
#include "core/resident_memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>

namespace penumbra {

namespace {

enum class Limit { none, time, memory };

// A signal handler can reach nothing but static, lock-free state.
Cancel cancelled;
std::atomic<int> signal_seen{0};
std::atomic<Limit> limit_met{Limit::none};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<Limit>::is_always_lock_free);

void on_signal(int signal) {
    signal_seen = signal;
    cancelled.raise();
    std::signal(signal, SIG_DFL);
}

/// Until a limit is met, or it is asked to stop.
void watch(const std::stop_token &stop, const Limits &limits) {
    using Clock = std::chrono::steady_clock;
    using Seconds = std::chrono::duration<double>;
    constexpr double longest_sleep = 3600, between_looks = 0.01; // [s]
    const auto start = Clock::now();
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any asleep;
    while (!stop.stop_requested()) {
        const double left = limits.seconds ? *limits.seconds - Seconds(Clock::now() - start).count() : longest_sleep;
        if (left <= 0 || (limits.memory_mib && resident_mib() > *limits.memory_mib)) {
            limit_met = left <= 0 ? Limit::time : Limit::memory;
            cancelled.raise();
            return;
        }
        asleep.wait_for(lock, stop, Seconds(std::min(left, limits.memory_mib ? between_looks : longest_sleep)),
                        [] { return false; });
    }
}

} // namespace

Interrupt::Interrupt(const Limits &limits) : limits_(limits) {
    cancelled.lower();
    signal_seen = 0;
    limit_met = Limit::none;
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
    if (limits.seconds || limits.memory_mib)
        watch_ = std::jthread([limits](const std::stop_token &stop) { watch(stop, limits); });
}

Interrupt::~Interrupt() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

const Cancel &Interrupt::cancel() const { return cancelled; }

void Interrupt::lift_limits() {
    watch_ = {};
    if (limit_met.exchange(Limit::none) != Limit::none && signal_seen == 0)
        cancelled.lower();
}

int Interrupt::exit_status() const {
    if (signal_seen != 0)
        return 128 + signal_seen;
    return limit_met != Limit::none ? not_reached : done;
}

std::string Interrupt::cause() const {
    if (signal_seen != 0)
        return "interrupt";
    return limit_met == Limit::time ? "time limit" : limit_met == Limit::memory ? "memory limit" : "";
}

std::string Interrupt::sentence() const {
    if (signal_seen != 0)
        return "interrupted";
    if (limit_met == Limit::time)
        return fmt::format("the time limit of {:g} s stopped it", *limits_.seconds);
    return limit_met == Limit::memory ? fmt::format("the memory limit of {:g} MiB stopped it", *limits_.memory_mib)
                                      : "";
}

} // namespace penumbra
