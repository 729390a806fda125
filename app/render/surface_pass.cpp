#include "render/surface_pass.h"

#include <cmath>

namespace penumbra {

SurfacePass::SurfacePass()
    : program_({"space.glsl", "patch.glsl", "surface.vert"},
               {"space.glsl", "patch.glsl", "radiosity.frag", "tone.glsl", "surface.frag"}) {}

void SurfacePass::draw(const Frame &frame, const GpuSnapshot &gpu, bool values, bool lamps_alone) const {
    program_.use();
    frame.set_space(program_);
    gpu.patches.bind(1);
    program_.set("patches", 1);
    gpu.vertices.bind(3);
    program_.set("vertices", 3);
    gpu.coefficients.bind(2);
    program_.set("coefficients", 2);
    program_.set("shading", static_cast<int>(frame.look.shading));
    program_.set("values", values ? 1 : 0);
    program_.set("lamps_alone", lamps_alone ? 1 : 0);
    program_.set("range", glm::vec2(frame.range.low, frame.range.high));
    program_.set("gain", static_cast<float>(std::exp2(frame.look.exposure_ev)));
    program_.set("false_colour", frame.look.false_colour ? 1 : 0);
    glDrawArrays(GL_TRIANGLES, 0, gpu.n_vertices);
}

} // namespace penumbra
