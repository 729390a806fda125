// What no mending can help: every check throws BadInput, one line with file and line, object, value and remedy.
#pragma once

#include "scene/build_scene.h"

namespace penumbra {

/// Largest number of corners of a polygon; its convex parts and triangles take more than linear time to find.
inline constexpr std::size_t most_corners = 10'000;

/// There are faces; coordinates are finite; material indices are in range; polygons have at most `most_corners`.
void check_faces(const RawScene &raw);

/// Materials that faces use have a reflectance in [0, 1) and a finite exitance that is not negative.
void check_materials(const RawScene &raw);

/// For the messages: "file.obj:12: face of 'wall'".
std::string who(const RawFace &face);

} // namespace penumbra
