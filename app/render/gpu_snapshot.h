// A snapshot's arrays as the shaders read them; layouts as in shaders/space.glsl, patch.glsl, line.vert and tint.vert.
#pragma once

#include "gl/texture_buffer.h"
#include "iteration/snapshot.h"
#include "render/camera.h"
#include "render/look.h"

#include <glm/glm.hpp>

#include <vector>

namespace penumbra {

/// Polygons of one style in one surface, drawn as a whole: `count` vertices from `first`.
struct TintGroup {
    int first = 0, count = 0;
    int surface = 0;
    int style = 0;
    glm::vec3 middle{0}; ///< for sorting by distance
};

struct GpuSnapshot {
    glm::dvec3 centre{0};
    double size = 1; ///< space = (scene's frame - centre) / size
    Bounds bounds;   ///< scene's frame
    Range range;     ///< common_range() of this snapshot alone

    gl::TextureBuffer surfaces, patches, coefficients, vertices, tints;
    gl::TextureBuffer mesh_lines, outlines, curves, links;
    gl::TextureBuffer newest_event; ///< empty but in the middle of a refinement
    int n_vertices = 0; ///< of the patches' triangles
    std::vector<TintGroup> covers, glass;
    std::vector<glm::vec4> surface_planes; ///< normal, offset: positive for points in front

    void upload(const Snapshot &snapshot);
    /// The curves that the filter shows.
    void upload_curves(const Snapshot &snapshot, const CurveFilter &filter);
};

} // namespace penumbra
