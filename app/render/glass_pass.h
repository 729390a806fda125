// What must be seen without hiding what is behind: blockers and the backs of single polygons, tinted and hatched; and
// the dark parts of surfaces that others lie on.
#pragma once

#include "render/frame.h"
#include "render/gpu_snapshot.h"

namespace penumbra {

class GlassPass {
public:
    GlassPass();
    /// Covers, opaque, on the fronts that face the eye.
    void draw_covers(const Frame &frame, const GpuSnapshot &gpu) const;
    /// Glass, far before near, blended.
    void draw_glass(const Frame &frame, const GpuSnapshot &gpu) const;

private:
    void prepare(const Frame &frame, const GpuSnapshot &gpu) const;

    gl::Program program_;
};

} // namespace penumbra
