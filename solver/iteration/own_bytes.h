// What a state that is kept costs.
#pragma once

#include <cstdint>

namespace penumbra {

struct State; // iteration/state.h

/// About the bytes that a state does not share with the one before it: elements, coefficients, and the links that are
/// new. `before` null: all.
std::int64_t own_bytes(const State &state, const State *before);

} // namespace penumbra
