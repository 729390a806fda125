#include "render/glass_pass.h"

#include "render/styles.h"

#include <algorithm>
#include <array>

namespace penumbra {
namespace {

bool faces_eye(const Frame &frame, const GpuSnapshot &gpu, int surface) {
    const glm::vec4 &plane = gpu.surface_planes[static_cast<std::size_t>(surface)];
    return glm::dot(glm::vec3(plane), frame.eye) + plane.w > 0;
}

} // namespace

GlassPass::GlassPass() : program_({"space.glsl", "tint.vert"}, {"tint.frag"}) {}

void GlassPass::prepare(const Frame &frame, const GpuSnapshot &gpu) const {
    program_.use();
    frame.set_space(program_);
    gpu.tints.bind(1);
    program_.set("vertices", 1);
    program_.set("origin", frame.origin);
    program_.set("hatch_period", 9 * frame.scale);
    const bool dark = frame.look.theme == Theme::dark;
    const glm::vec4 smoke = dark ? glm::vec4(0.62, 0.68, 0.78, 0.2) : glm::vec4(0.25, 0.29, 0.36, 0.25);
    const glm::vec4 smoke_hatch = dark ? glm::vec4(0.75, 0.8, 0.88, 0.3) : glm::vec4(0.12, 0.14, 0.2, 0.45);
    std::array<glm::vec4, 4> fills{}, hatches{};
    for (const SurfaceRole role : {SurfaceRole::reflector, SurfaceRole::blocker}) {
        fills[static_cast<std::size_t>(styles::glass(role))] = smoke;
        hatches[static_cast<std::size_t>(styles::glass(role))] = smoke_hatch;
    }
    fills[static_cast<std::size_t>(styles::glass(SurfaceRole::emitter))] = {1.0, 0.8, 0.4, 0.22};
    hatches[static_cast<std::size_t>(styles::glass(SurfaceRole::emitter))] = {0.95, 0.66, 0.2, 0.35};
    fills[styles::cover] = {0.02, 0.02, 0.025, 1};
    hatches[styles::cover] = {0, 0, 0, 0};
    program_.set("fills", fills);
    program_.set("hatches", hatches);
}

void GlassPass::draw_covers(const Frame &frame, const GpuSnapshot &gpu) const {
    if (gpu.covers.empty())
        return;
    prepare(frame, gpu);
    for (const TintGroup &cover : gpu.covers)
        if (faces_eye(frame, gpu, cover.surface))
            glDrawArrays(GL_TRIANGLES, cover.first, cover.count);
}

void GlassPass::draw_glass(const Frame &frame, const GpuSnapshot &gpu) const {
    std::vector<TintGroup> seen;
    for (const TintGroup &group : gpu.glass)
        if (group.style == styles::glass(SurfaceRole::blocker) || !faces_eye(frame, gpu, group.surface))
            seen.push_back(group);
    if (seen.empty())
        return;
    std::stable_sort(seen.begin(), seen.end(), [&](const TintGroup &a, const TintGroup &b) {
        return glm::distance(a.middle, frame.eye) > glm::distance(b.middle, frame.eye);
    });
    prepare(frame, gpu);
    for (const TintGroup &group : seen)
        glDrawArrays(GL_TRIANGLES, group.first, group.count);
}

} // namespace penumbra
