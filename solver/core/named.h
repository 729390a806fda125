// From public names back to values.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace penumbra {

/// The one of that name().
template <class T, std::size_t n>
std::optional<T> named(const T (&all)[n], std::string_view text) {
    for (const T one : all)
        if (name(one) == text)
            return one;
    return std::nullopt;
}

} // namespace penumbra
