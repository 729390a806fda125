// Radiosity along a line, as a table for scripts.
#pragma once

#include "iteration/profile.h"
#include "plot/profile_sheet.h"

#include <string>

namespace penumbra {

/// Rows of the truth, then of each solution, in the order of the line; a border of elements has two rows, of the
/// element before and the one behind. Columns:
///   curve             truth, or the strategy
///   at                distance from the line's beginning
///   x, y, z           the point, in the scene's own frame
///   r, g, b           radiosity [W/m2]
///   slope_r, slope_g, slope_b   its derivative along the line: of a solution its polynomials' own, of the truth by
///   differences
///                     over difference_step() of the line to either side
///   element           number of the piece of the solution; empty for the truth
std::string profile_csv(const ProfileLine &line, const ProfileData &data);

} // namespace penumbra
