// From raw faces to a checked scene. Every reader ends here; input is checked once, here.
#pragma once

#include "scene/scene.h"

namespace penumbra {

/// A face as a file gives it, in the file's own frame and unchecked.
struct RawFace {
    std::string object;        ///< for messages
    std::string where;         ///< for messages: "file.obj:12"
    int material = 0;
    bool double_sided = false;
    std::vector<Vec3> corners;
};

struct RawScene {
    std::string name;
    std::filesystem::path file;
    std::vector<Material> materials;
    std::vector<RawFace> faces;
    Vec3 up = Vec3::UnitZ();
    std::vector<std::string> notes;
    std::string reflectance_key = "Kd", exitance_key = "Ke"; ///< what the file calls them, for messages
};

/// Checks, mends and normalises. Throws BadInput (not finite, index out of range, a polygon that crosses itself,
/// reflectance outside [0, 1), a negative exitance, no surface), one line each. Mends and notes: duplicate points and
/// faces without area are dropped, faces bent by at most 1e-6 of their size are flattened, others cut into triangles.
/// Finds the covers of coplanar overlaps.
Scene build_scene(RawScene raw);

} // namespace penumbra
