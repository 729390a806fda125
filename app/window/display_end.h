// When the connection to the display ends: Xlib then ends the program by itself, from wherever it is.
#pragma once

#include <functional>
#include <string>

namespace penumbra {

/// While it lives, an exit of the program other than by returning from here is taken for that: one line with what
/// `rescue` says, and status 5. One at a time.
class DisplayEnd {
public:
    explicit DisplayEnd(std::function<std::string()> rescue);
    ~DisplayEnd();
    DisplayEnd(const DisplayEnd &) = delete;
    DisplayEnd &operator=(const DisplayEnd &) = delete;
};

} // namespace penumbra
