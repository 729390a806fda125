#include "discontinuity/curve.h"

#include <array>

namespace penumbra {

std::string_view name(CurveKind kind) {
    constexpr std::array<std::string_view, 5> names{"VE", "EV", "EEE", "plane", "contact"};
    return names[static_cast<std::size_t>(kind)];
}

} // namespace penumbra
