// Typed indices: an element's number cannot be taken for a surface's.
#pragma once

#include <compare>
#include <cstddef>
#include <functional>

namespace penumbra {

/// An index into the array of things named by Tag; -1 is "none".
template <class Tag>
struct Id {
    int index = -1;

    constexpr Id() = default;
    constexpr explicit Id(int i) : index(i) {}
    constexpr explicit Id(std::size_t i) : index(static_cast<int>(i)) {}
    constexpr bool valid() const { return index >= 0; }
    constexpr std::size_t at() const { return static_cast<std::size_t>(index); }
    constexpr auto operator<=>(const Id &) const = default;
};

using SurfaceId = Id<struct SurfaceTag>;
using ElementId = Id<struct ElementTag>;
using CurveId = Id<struct CurveTag>;

} // namespace penumbra
