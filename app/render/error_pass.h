// How wrong the solution is, in place of the light: reflectors coloured by their distance from the truth.
#pragma once

#include "render/frame.h"
#include "render/gpu_snapshot.h"

namespace penumbra {

struct ErrorMap; // iteration/error_map.h

class ErrorPass {
public:
    ErrorPass();
    /// Brings the map to the GPU, with the numbers of whole patches that the kind has.
    void upload(const Snapshot &snapshot, const ErrorMap &map, ErrorKind kind);
    /// `values`: writes the number itself in place of its colour, for a float target.
    void draw(const Frame &frame, const GpuSnapshot &gpu, bool values) const;

private:
    gl::Program program_;
    gl::TextureBuffer vertices_;
    double peak_ = 1;
};

} // namespace penumbra
