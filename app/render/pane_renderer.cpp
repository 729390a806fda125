#include "render/pane_renderer.h"

#include "core/check.h"
#include "iteration/error_map.h"
#include "render/critical_pass.h"
#include "render/curve_pass.h"
#include "render/error_pass.h"
#include "render/glass_pass.h"
#include "render/gpu_snapshot.h"
#include "render/link_pass.h"
#include "render/mesh_pass.h"
#include "render/surface_pass.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace penumbra {

PixelRect overlap(const PixelRect &a, const PixelRect &b) {
    const int left = std::max(a.x, b.x), top = std::max(a.y, b.y);
    return {left, top, std::max(0, std::min(a.x + a.width, b.x + b.width) - left),
            std::max(0, std::min(a.y + a.height, b.y + b.height) - top)};
}

namespace {

/// The rectangle, or as much of it about the part as the driver's largest viewport holds. Not the part alone: Mesa
/// interpolates what is `noperspective` wrongly at a viewport's corners, and lines would have gaps there.
PixelRect viewport_about(const PixelRect &part, const PixelRect &rect) {
    GLint most[2] = {0, 0};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, most);
    const auto from = [](int low, int size, int part_low, int part_size, int limit) {
        return size <= limit ? low : std::clamp(part_low + (part_size - limit) / 2, low, low + size - limit);
    };
    return {from(rect.x, rect.width, part.x, part.width, most[0]),
            from(rect.y, rect.height, part.y, part.height, most[1]), std::min(rect.width, static_cast<int>(most[0])),
            std::min(rect.height, static_cast<int>(most[1]))};
}

/// From the frame of a rectangle to the frame of a part of it: [-1, 1] is that part.
glm::dmat4 onto(const PixelRect &rect, const PixelRect &seen) {
    const glm::dvec2 scale(static_cast<double>(rect.width) / seen.width, static_cast<double>(rect.height) / seen.height);
    const glm::dvec2 middle((2.0 * (seen.x - rect.x) + seen.width) / rect.width - 1,
                            1 - (2.0 * (seen.y - rect.y) + seen.height) / rect.height);
    glm::dmat4 window(1);
    window[0][0] = scale.x;
    window[1][1] = scale.y;
    window[3][0] = -scale.x * middle.x;
    window[3][1] = -scale.y * middle.y;
    return window;
}

} // namespace

struct PaneRenderer::Parts {
    GpuSnapshot gpu;
    SurfacePass surfaces;
    ErrorPass errors;
    GlassPass glass;
    LinePass lines;
    gl::VertexArray no_attributes; // shaders fetch what they need by gl_VertexID
    CriticalPass critical;
    std::shared_ptr<const Snapshot> snapshot; // null before the first upload
    std::uint64_t version = 0;                // of the snapshot when it was uploaded
    std::shared_ptr<const ErrorMap> map;      // of the snapshot; null: not known
    std::optional<ErrorKind> kind;            // that the errors are there for; none: they are not
    std::optional<CurveFilter> filter;        // of the curves that are there; none: not yet
    std::optional<Spotlight> spotlight;

    /// Curves follow the look, which may change from frame to frame while the snapshot stays.
    void follow(const Look &look) {
        if (filter != look.curve_filter)
            gpu.upload_curves(*snapshot, look.curve_filter);
        if (spotlight != look.spotlight)
            critical.upload(*snapshot, look.spotlight);
        filter = look.curve_filter;
        spotlight = look.spotlight;
        if (look.shading == Shading::error && map)
            bring_errors(look.error);
    }
    void bring_errors(ErrorKind wanted) {
        if (kind != wanted)
            errors.upload(*snapshot, *map, wanted);
        kind = wanted;
    }
    void draw_surfaces(const Frame &frame) {
        const bool wrong = frame.look.shading == Shading::error && map;
        surfaces.draw(frame, gpu, false, wrong);
        if (wrong)
            errors.draw(frame, gpu, false);
    }

    /// Of this viewport on the rectangle.
    Frame frame(const Camera &camera, const Look &look, const PixelRect &rect, const PixelRect &viewport,
                PixelScale pixel_scale) const {
        const auto to_unit = [&](const glm::dvec3 &x) { return (x - gpu.centre) / gpu.size; };
        const Camera unit{to_unit(camera.eye), to_unit(camera.target), camera.up, camera.fov_y};
        const Bounds box{to_unit(gpu.bounds.low), to_unit(gpu.bounds.high)};
        Frame frame;
        frame.view = view_matrix(unit);
        const glm::dmat4 projection = projection_matrix(unit, rect.aspect(), box);
        frame.projection = onto(rect, viewport) * projection;
        frame.eye = unit.eye;
        frame.viewport = {viewport.width, viewport.height};
        frame.near = static_cast<float>(projection[3][2] / (projection[2][2] - 1));
        frame.pixel = static_cast<float>(2 * std::tan(glm::radians(camera.fov_y) / 2) *
                                         glm::distance(unit.eye, unit.target) / rect.height);
        frame.scale = static_cast<float>(pixel_scale.factor);
        frame.look = look;
        frame.range = look.range.value_or(gpu.range);
        return frame;
    }
};

PaneRenderer::PaneRenderer() : parts_(std::make_unique<Parts>()) {}
PaneRenderer::~PaneRenderer() = default;

void PaneRenderer::upload(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const ErrorMap> errors) {
    if (errors)
        PENUMBRA_CHECK(errors->version, ==, snapshot->version);
    if (parts_->map != errors)
        parts_->kind.reset();
    parts_->map = std::move(errors);
    if (parts_->snapshot && parts_->version == snapshot->version)
        return;
    parts_->gpu.upload(*snapshot);
    parts_->version = snapshot->version;
    parts_->snapshot = std::move(snapshot);
    parts_->filter.reset();
    parts_->spotlight.reset();
}

namespace {

/// Restricts drawing to the rectangle; clears it.
void open(const PixelRect &rect, int framebuffer_height, const glm::vec4 &background) {
    const int bottom = framebuffer_height - rect.y - rect.height;
    glViewport(rect.x, bottom, rect.width, rect.height);
    glScissor(rect.x, bottom, rect.width, rect.height);
    glEnable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(background.r, background.g, background.b, background.a);
    glClearDepth(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
}

void close() {
    glBindVertexArray(0);
    glUseProgram(0);
    glActiveTexture(GL_TEXTURE0);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

} // namespace

void PaneRenderer::draw(const Camera &camera, const Look &look, const PixelRect &rect, int framebuffer_height,
                        PixelScale pixel_scale, const std::optional<PixelRect> &part,
                        const std::optional<PixelRect> &only) {
    const PixelRect drawn = only ? overlap(rect, *only) : rect, seen = part ? overlap(drawn, *part) : drawn;
    if (seen.width < 1 || seen.height < 1)
        return;
    const PixelRect corner = part.value_or(PixelRect{0, 0, 0, framebuffer_height});
    open({seen.x - corner.x, seen.y - corner.y, seen.width, seen.height}, corner.height,
         look.transparent ? glm::vec4(0) : background_colour(look.theme));
    if (parts_->snapshot) {
        parts_->follow(look);
        const PixelRect viewport = viewport_about(seen, rect);
        glViewport(viewport.x - corner.x, corner.y + corner.height - viewport.y - viewport.height, viewport.width,
                   viewport.height);
        Frame frame = parts_->frame(camera, look, rect, viewport, pixel_scale);
        frame.origin = {corner.x - rect.x, rect.y + rect.height - corner.y - corner.height};
        const GpuSnapshot &gpu = parts_->gpu;
        glBindVertexArray(parts_->no_attributes.name());
        gpu.surfaces.bind(0);
        // A line is as deep as its middle all over its width: surfaces make room by as many pixels of their own slope.
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(3 * frame.scale, 4);
        parts_->draw_surfaces(frame);
        parts_->glass.draw_covers(frame, gpu);
        glDisable(GL_POLYGON_OFFSET_FILL);
        glEnable(GL_BLEND);
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glDepthMask(GL_FALSE);
        if (look.layers.mesh)
            draw_mesh(parts_->lines, frame, gpu);
        if (look.layers.curves)
            draw_curves(parts_->lines, frame, gpu);
        draw_newest_event(parts_->lines, frame, gpu);
        parts_->glass.draw_glass(frame, gpu);
        draw_outlines(parts_->lines, frame, gpu);
        if (look.layers.links)
            draw_links(parts_->lines, frame, gpu);
        parts_->critical.draw(parts_->lines, frame);
    }
    close();
}

void PaneRenderer::draw_values(const Camera &camera, Shading shading, const PixelRect &rect, int framebuffer_height) {
    open(rect, framebuffer_height, glm::vec4(0));
    if (parts_->snapshot) {
        Look look;
        look.shading = shading;
        const Frame frame = parts_->frame(camera, look, rect, rect, {});
        glBindVertexArray(parts_->no_attributes.name());
        parts_->gpu.surfaces.bind(0);
        parts_->surfaces.draw(frame, parts_->gpu, true);
    }
    close();
}

void PaneRenderer::draw_error_values(const Camera &camera, ErrorKind kind, const PixelRect &rect,
                                     int framebuffer_height) {
    open(rect, framebuffer_height, glm::vec4(0));
    if (parts_->snapshot && parts_->map) {
        Look look;
        look.shading = Shading::error;
        look.error = kind;
        parts_->bring_errors(kind);
        const Frame frame = parts_->frame(camera, look, rect, rect, {});
        glBindVertexArray(parts_->no_attributes.name());
        parts_->errors.draw(frame, parts_->gpu, true);
    }
    close();
}

} // namespace penumbra
