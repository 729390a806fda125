// GL with no display: an EGL surfaceless context.
#pragma once

#include <memory>

namespace penumbra {

class Offscreen {
public:
    /// Makes a GL 4.1 core context (or newer) current on this thread. Throws Unavailable when the machine has none.
    Offscreen();
    ~Offscreen();
    Offscreen(const Offscreen &) = delete;
    Offscreen &operator=(const Offscreen &) = delete;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace penumbra
