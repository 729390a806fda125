// Random numbers that any thread can make for any index: the same for the same seed, whoever asks first.
#pragma once

#include <cstdint>

namespace penumbra {

/// Bits well mixed from the state (Steele, Lea & Flood 2014, SplitMix64).
constexpr std::uint64_t mixed(std::uint64_t state) {
    state += 0x9e3779b97f4a7c15u;
    state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
    state = (state ^ (state >> 27)) * 0x94d049bb133111ebu;
    return state ^ (state >> 31);
}

/// A stream of numbers uniform in [0, 1).
class Random {
public:
    constexpr explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : state_(mixed(seed ^ mixed(stream))) {}
    constexpr double next() { return static_cast<double>(mixed(state_++) >> 11) * 0x1p-53; }

private:
    std::uint64_t state_;
};

} // namespace penumbra
