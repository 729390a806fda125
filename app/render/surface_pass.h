// Lit fronts of reflectors and emitters: every fragment evaluates its element's polynomial.
#pragma once

#include "render/frame.h"
#include "render/gpu_snapshot.h"

namespace penumbra {

class SurfacePass {
public:
    SurfacePass();
    /// `values`: writes radiosity itself [W/m2] in place of colours, for a float target. `lamps_alone`: surfaces that
    /// reflect are left out.
    void draw(const Frame &frame, const GpuSnapshot &gpu, bool values, bool lamps_alone = false) const;

private:
    gl::Program program_;
};

} // namespace penumbra
