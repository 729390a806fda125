#include "window/display_end.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace penumbra {

namespace {

constexpr int unavailable = 5; ///< exit status

std::function<std::string()> rescue_now; ///< empty: the ordinary way out of main

void on_exit() {
    if (!rescue_now)
        return;
    std::fprintf(stderr, "penumbra: the display has gone; %s\n", rescue_now().c_str());
    std::_Exit(unavailable);
}

} // namespace

DisplayEnd::DisplayEnd(std::function<std::string()> rescue) {
    static const bool once [[maybe_unused]] = std::atexit(on_exit) == 0;
    rescue_now = std::move(rescue);
}

DisplayEnd::~DisplayEnd() { rescue_now = nullptr; }

} // namespace penumbra
