// A scene with some of its objects elsewhere, or of another size.
#pragma once

#include "scene/scene.h"

#include <span>

namespace penumbra {

/// The front surfaces that one object of the file is made of: all that carry its name, or the surface alone where it
/// has none. Backs belong to the object of their front.
std::vector<int> object_surfaces(const Scene &scene, SurfaceId surface);

/// Of an object, relative to where the file has it; everything in the scene's own frame.
struct ObjectMove {
    int surface = 0;           ///< the first of object_surfaces()
    Vec3 offset = Vec3::Zero(); ///< of its centre [length]
    double scale = 1;          ///< about its centre; above 0

    bool operator==(const ObjectMove &) const = default;
};

/// The middle of the box about an object's corners [own frame].
Vec3 object_centre(const Scene &scene, SurfaceId surface);

/// The scene with these objects moved, checked anew: a surface keeps its number, name and material; what lies on what is found
/// anew. Throws BadInput where there is no such surface, a number is not finite, a scale is not above 0, or what comes of it is
/// no scene.
Scene with_moves(const Scene &scene, std::span<const ObjectMove> moves);

} // namespace penumbra
