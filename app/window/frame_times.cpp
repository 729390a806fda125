#include "window/frame_times.h"

#include "core/atomic_write.h"

#include <fmt/format.h>

namespace penumbra {

void FrameTimes::end(bool busy, bool moving) {
    const std::chrono::duration<double> since = begun_ - first_, taken = Clock::now() - begun_;
    rows_ += fmt::format("{:.4f},{:.3f},{:d},{:d}\n", since.count(), 1e3 * taken.count(), busy, moving);
}

void FrameTimes::write() const { write_atomically(file_, rows_); }

} // namespace penumbra
