#include "study/run_watch.h"

#include "core/resident_memory.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace penumbra {

RunWatch::RunWatch(const RunLimits &limits, const Cancel &all)
    : thread_([this, limits, &all](const std::stop_token &stop) {
          using Clock = std::chrono::steady_clock;
          const auto start = Clock::now();
          std::mutex mutex;
          std::unique_lock lock(mutex);
          std::condition_variable_any asleep;
          while (!stop.stop_requested()) {
              const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
              if (limits.seconds && seconds >= *limits.seconds)
                  met_ = Met::time;
              else if (limits.memory_mib && resident_mib() > *limits.memory_mib)
                  met_ = Met::memory;
              if (met_ != Met::nothing || all.raised())
                  return cancel_.raise();
              asleep.wait_for(lock, stop, std::chrono::milliseconds(5), [] { return false; });
          }
      }) {}

} // namespace penumbra
