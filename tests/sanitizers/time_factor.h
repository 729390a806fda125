// How much longer sanitized programs take; 1 in every other build.
#pragma once

namespace penumbra {

/// PENUMBRA_TIME_FACTOR, which the presets `asan` and `tsan` set: limits of wall time are multiplied by it.
inline constexpr double time_factor = PENUMBRA_TIME_FACTOR;

} // namespace penumbra
