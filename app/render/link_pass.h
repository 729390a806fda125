// Links, from receiver to source centres, coloured by how they are integrated.
#pragma once

#include "render/gpu_snapshot.h"
#include "render/line_pass.h"

namespace penumbra {

void draw_links(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu);

} // namespace penumbra
