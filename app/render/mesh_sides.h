// What a mesh of patches with hanging corners looks like as a whole: its sides, each once, its borders without cracks,
// and its corner values.
#pragma once

#include "iteration/snapshot.h"

#include <vector>

namespace penumbra {

/// A piece of side between two neighbouring corners of the mesh.
struct MeshSide {
    int surface = 0;
    Vec2 from, to;
    SideKind kind = SideKind::uniform; ///< cut if it is one to either of its patches
    bool fresh = false;                ///< of a patch made in this iteration
};

struct MeshSides {
    std::vector<MeshSide> sides;
    /// By patch: its corners and the corners of others that lie on its sides, counter-clockwise, no point twice; the very
    /// same points in all patches that share them. Triangles with these as vertices leave no cracks.
    std::vector<std::vector<Vec2>> borders;
    /// By patch, at its corners and at all points of its border: radiosity there, averaged over the patches of the
    /// surface that meet there, by corner or by side (Gouraud).
    std::vector<std::vector<Rgb>> corner_values, border_values;
};

MeshSides mesh_sides(const Snapshot &snapshot);

} // namespace penumbra
