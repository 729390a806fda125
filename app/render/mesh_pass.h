// Sides of the patches: quiet, one pixel wide; cuts are told from uniform splits, and what is new stands out.
#pragma once

#include "render/gpu_snapshot.h"
#include "render/line_pass.h"
#include "render/surface_role.h"

namespace penumbra {

/// How the sides of one kind are drawn; the legend shows the same.
glm::vec4 mesh_colour(SideKind kind, bool fresh);
float mesh_width(SideKind kind, bool fresh);

void draw_mesh(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu);
/// The last split shown in the middle of a refinement.
glm::vec4 newest_event_colour();
float newest_event_width();
void draw_newest_event(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu);
glm::vec4 outline_colour(SurfaceRole role, Theme theme);
float outline_width(SurfaceRole role);
/// Borders of all surfaces, so that rooms and lamps keep their shape with the mesh off.
void draw_outlines(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu);

} // namespace penumbra
