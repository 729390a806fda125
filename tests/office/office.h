// Offices of any size: closed rooms with furniture on both sides of a corridor.
#pragma once

#include <string>

namespace penumbra {

struct SceneText {
    std::string obj, mtl;
};

/// Of the rooms that come nearest to `n_polygons` polygons, at least one: each has 76, and the corridor 6. Rooms are 4
/// x 5 x 2.7 (metres, z up), behind walls of 0.2, with a door to the corridor, a desk, a chair, a cabinet, a screen and
/// a lamp in the ceiling; chairs are turned differently. Surfaces meet without gaps, and all furniture is of closed
/// boxes. The same number gives the same text. `name` stands in the text as that of the MTL file.
SceneText office(int n_polygons, const std::string &name = "office");

} // namespace penumbra
