// One curve in the limelight: the curve itself, the surface of lines of sight that throws it, some of these lines, and
// the edges and corners that they touch.
#pragma once

#include "render/frame.h"
#include "render/gpu_snapshot.h"
#include "render/line_pass.h"

namespace penumbra {

class CriticalPass {
public:
    CriticalPass();
    /// Takes the snapshot's curve, or none when there is no such one.
    void upload(const Snapshot &snapshot, const Spotlight &spotlight);
    /// Blends it over what is there, hidden by what stands before it.
    void draw(const LinePass &lines, const Frame &frame) const;

private:
    gl::Program program_;
    gl::TextureBuffer sheet_, sights_, segments_;
    int kind_ = 0;
};

} // namespace penumbra
