// What an element's borders are.
#pragma once

#include <cstdint>

namespace penumbra {

/// What lies along a side of an element.
enum class SideKind : std::uint8_t { outline, uniform, cut };

} // namespace penumbra
