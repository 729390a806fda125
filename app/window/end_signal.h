// Ctrl+C and a polite kill, while the window is open.
#pragma once

#include <functional>
#include <thread>

namespace penumbra {

/// While it lives, the first SIGINT or SIGTERM is noted and `wake` is called, from a thread of its own, in place of
/// ending the program; a second one ends it. One at a time.
class EndSignal {
public:
    explicit EndSignal(std::function<void()> wake);
    ~EndSignal();
    EndSignal(const EndSignal &) = delete;
    EndSignal &operator=(const EndSignal &) = delete;

    int seen() const; ///< 0: none
private:
    std::thread listener_;
};

} // namespace penumbra
