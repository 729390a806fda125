#include "core/parallel.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#ifdef PENUMBRA_JTHREADS
#include <exception>
#include <vector>
#else
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace penumbra {

namespace {
std::atomic<int> n_threads{0};
}

int threads() {
    const int n = n_threads;
    return n > 0 ? n : static_cast<int>(std::thread::hardware_concurrency());
}

#ifdef PENUMBRA_JTHREADS

void set_threads(int n) { n_threads = n; }

void parallel_for(std::size_t n, const std::function<void(std::size_t)> &body) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto work = [&] {
        for (std::size_t i = next++; i < n; i = next++) {
            try {
                body(i);
            } catch (...) {
                const std::lock_guard lock(failure_mutex);
                if (!failure)
                    failure = std::current_exception();
                next = n;
            }
        }
    };
    {
        std::vector<std::jthread> team;
        for (int i = 1; i < threads(); ++i)
            team.emplace_back(work);
        work();
    }
    if (failure)
        std::rethrow_exception(failure);
}

#else

void set_threads(int n) {
    // TBB starts no more workers than there are cores, and complains on standard error, unless told that more are meant.
    static std::mutex mutex; // guards limit
    static std::unique_ptr<tbb::global_control> limit;
    const std::lock_guard lock(mutex);
    if (n_threads.exchange(n) == n)
        return;
    limit.reset(); // several at a time: the least would hold
    if (n > 0)
        limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(n));
}

void parallel_for(std::size_t n, const std::function<void(std::size_t)> &body) {
    if (threads() == 1 || n < 2) {
        for (std::size_t i = 0; i < n; ++i)
            body(i);
        return;
    }
    tbb::task_arena arena(threads());
    arena.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 1), [&](const tbb::blocked_range<std::size_t> &range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                body(i);
        });
    });
}

#endif

} // namespace penumbra
