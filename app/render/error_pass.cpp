#include "render/error_pass.h"

#include "iteration/error_map.h"
#include "render/error_scale.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra {

namespace {

glm::vec2 to_vec2(const Vec2 &p) { return {static_cast<float>(p.x()), static_cast<float>(p.y())}; }

} // namespace

ErrorPass::ErrorPass() : program_({"space.glsl", "error.vert"}, {"tone.glsl", "diverging.glsl", "error.frag"}) {}

void ErrorPass::upload(const Snapshot &snapshot, const ErrorMap &map, ErrorKind kind) {
    const double size = std::max(bounds(snapshot).size(), 1e-300);
    std::vector<glm::vec4> texels;
    for (std::size_t i = 0; i < map.patches.size(); ++i) {
        const PatchError &error = map.patches[i];
        if (error.n == 0)
            continue;
        const auto value = static_cast<float>(patch_value(kind, snapshot, map, i));
        const auto surface = static_cast<float>(snapshot.patches[i].surface);
        const std::size_t side = static_cast<std::size_t>(error.n) + 2;
        const auto add = [&](std::size_t at) {
            const Rgb &m = error.missed[at];
            texels.emplace_back(to_vec2(error.points[at] / size), surface, value);
            texels.emplace_back(m[0], m[1], m[2], 0);
        };
        for (std::size_t tile = 0; tile < error.points.size(); tile += side * side)
            for (std::size_t row = 0; row + 1 < side; ++row)
                for (std::size_t column = 0; column + 1 < side; ++column) {
                    const std::size_t at = tile + row * side + column;
                    for (const std::size_t corner : {at, at + 1, at + side + 1, at, at + side + 1, at + side})
                        add(corner);
                }
    }
    vertices_.upload(texels);
    peak_ = map.peak > 0 ? map.peak : 1;
}

void ErrorPass::draw(const Frame &frame, const GpuSnapshot &gpu, bool values) const {
    program_.use();
    frame.set_space(program_);
    gpu.surfaces.bind(0);
    vertices_.bind(3);
    program_.set("vertices", 3);
    const ErrorKind kind = frame.look.error;
    const Range range = frame.look.error_range.value_or(Range{-1, 1});
    const auto end = [&](double x) { return static_cast<float>(is_logarithmic(kind) ? std::log(x) : x); };
    program_.set("kind", static_cast<int>(kind));
    program_.set("peak", static_cast<float>(peak_));
    program_.set("ends", glm::vec2(end(range.low), end(range.high)));
    program_.set("values", values ? 1 : 0);
    glDrawArrays(GL_TRIANGLES, 0, vertices_.size() / 2);
}

} // namespace penumbra
