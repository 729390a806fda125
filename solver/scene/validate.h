// What no mending can help: every check throws BadInput, one line with file and line, object, value and remedy.
#pragma once

#include "scene/build_scene.h"

namespace penumbra {

/// Largest number of corners of a polygon; its convex parts and triangles take more than linear time to find.
inline constexpr std::size_t most_corners = 10'000;

/// Largest numbers of faces and of their corners together: what is larger takes hours to solve.
inline constexpr std::size_t most_faces = 200'000, most_corners_in_all = 2'000'000;

/// Counts faces while they are read, so that a scene is refused before it uses up the memory.
class FaceCount {
public:
    void add(const std::string &file, std::size_t n_corners);

private:
    std::size_t n_faces_ = 0, n_corners_ = 0;
};

/// Longest name of an object or material [bytes]; each surface carries its own.
inline constexpr std::size_t longest_name = 256;

/// Largest number of materials in a file.
inline constexpr std::size_t most_materials = 10'000;

/// There are faces; coordinates are finite; material indices are in range; polygons have at most `most_corners`.
void check_faces(const RawScene &raw);

/// Materials that faces use have a reflectance in [0, 1) and a finite exitance that is not negative.
void check_materials(const RawScene &raw);

/// For the messages: "file.obj:12: face of 'wall'".
std::string who(const RawFace &face);

} // namespace penumbra
