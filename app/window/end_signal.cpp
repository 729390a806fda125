#include "window/end_signal.h"

#include "core/error.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <unistd.h>
#include <utility>

namespace penumbra {

namespace {

constexpr char came = 's', over = 'q';

// A signal handler can reach nothing but static state, and wake a thread only through a pipe.
std::atomic<int> signal_seen{0};
std::array<int, 2> ends{-1, -1};

void say(char what) {
    const int reason = errno;
    [[maybe_unused]] const ssize_t n = ::write(ends[1], &what, 1);
    errno = reason;
}

void on_signal(int signal) {
    signal_seen = signal;
    std::signal(signal, SIG_DFL);
    say(came);
}

void listen(const std::function<void()> &wake) {
    for (char word = came; word != over;) {
        const ssize_t n = ::read(ends[0], &word, 1);
        if (n < 0 && errno != EINTR)
            return;
        if (n == 1 && word == came)
            wake();
    }
}

} // namespace

EndSignal::EndSignal(std::function<void()> wake) {
    if (::pipe(ends.data()) != 0)
        throw Unavailable(std::string("cannot make a pipe: ") + std::strerror(errno));
    signal_seen = 0;
    listener_ = std::thread([wake = std::move(wake)] { listen(wake); });
    std::signal(SIGINT, on_signal);
    std::signal(SIGTERM, on_signal);
}

EndSignal::~EndSignal() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    say(over);
    listener_.join();
    ::close(ends[0]);
    ::close(ends[1]);
}

int EndSignal::seen() const { return signal_seen; }

} // namespace penumbra
