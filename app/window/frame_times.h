// How long frames take, for tests/bench/window_table.cpp.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace penumbra {

/// CSV with a row a frame: `seconds` since the first, `milliseconds` from its begin to the swapped buffers, `busy` (the solver
/// works), `moving` (the view is dragged, which is drawn with one sample a pixel).
class FrameTimes {
public:
    explicit FrameTimes(std::filesystem::path file) : file_(std::move(file)) {}
    void begin() { begun_ = Clock::now(); }
    void end(bool busy, bool moving);
    /// Throws Unavailable.
    void write() const;

private:
    using Clock = std::chrono::steady_clock;

    std::filesystem::path file_;
    Clock::time_point first_ = Clock::now(), begun_ = first_;
    std::string rows_ = "seconds,milliseconds,busy,moving\n";
};

} // namespace penumbra
