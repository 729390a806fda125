// The shelf's compartments, a file each.
#pragma once

#include "study/hard_cases.h"

namespace penumbra {

std::vector<HardCase> touching_cases();    ///< patches that share an edge, a corner or a plane
std::vector<HardCase> blocker_cases();     ///< what stands in the light, on and in what it shades
std::vector<HardCase> shape_cases();       ///< slivers, sizes far apart, grazing light, polygons of many corners
std::vector<HardCase> cutting_cases();     ///< cuts by the thousand, and almost in one place
std::vector<HardCase> moved_cases();       ///< one scene in other places, sizes and turned round
std::vector<HardCase> closed_room_cases(); ///< rooms that keep all light, or have none

} // namespace penumbra
