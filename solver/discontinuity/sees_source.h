// Whether anything of the source is seen from one point.
#pragma once

#include "discontinuity/source_view.h"

#include <span>
#include <vector>

namespace penumbra {

/// Whether a part of the source is seen from x within the half-spaces (y - x) . n >= 0 of the given normals, past the
/// given facets but those listed in `ignored` (ascending; those that x itself touches).
bool sees_source(const SourceView &view, const Vec3 &x, std::span<const Vec3> half_spaces,
                 std::span<const std::size_t> facets, std::span<const std::size_t> ignored);

} // namespace penumbra
