#include "render/mesh_pass.h"

#include "render/curve_pass.h"
#include "render/styles.h"

namespace penumbra {

glm::vec4 mesh_colour(SideKind kind, bool fresh) {
    if (kind == SideKind::cut)
        return {0.03, 0.05, 0.09, 0.95};
    return fresh ? glm::vec4(0.0, 0.45, 0.85, 0.85) : glm::vec4(0.16, 0.28, 0.45, 0.5);
}

float mesh_width(SideKind kind, bool) { return kind == SideKind::cut ? 1.6f : 1.f; }

void draw_mesh(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu) {
    LineStyles styles;
    for (const SideKind kind : {SideKind::outline, SideKind::uniform, SideKind::cut})
        for (const bool fresh : {false, true})
            styles.set(styles::mesh_side(kind, fresh),
                       mesh_colour(kind, fresh && frame.look.emphasise_fresh && kind != SideKind::outline),
                       kind == SideKind::outline ? 0.f : mesh_width(kind, fresh));
    lines.draw(frame, gpu.mesh_lines, styles, 4e-4f);
}

glm::vec4 newest_event_colour() { return {0.941, 0.894, 0.259, 1}; } // yellow, which no kind of curve has
float newest_event_width() { return 2.5f; }

void draw_newest_event(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu) {
    if (gpu.newest_event.size() == 0)
        return;
    LineStyles styles;
    styles.set(styles::newest_side, newest_event_colour(), newest_event_width());
    for (int kind = 0; kind < 5; ++kind)
        styles.set(styles::newest_curve(kind), curve_rgba(kind), 4.f);
    lines.draw(frame, gpu.newest_event, styles, 1e-3f, {0.03, 0.04, 0.06, 0.85});
}

glm::vec4 outline_colour(SurfaceRole role, Theme theme) {
    const bool dark = theme == Theme::dark;
    if (role == SurfaceRole::emitter)
        return {0.95, 0.62, 0.1, 1};
    if (role == SurfaceRole::blocker)
        return dark ? glm::vec4(0.8, 0.83, 0.88, 0.9) : glm::vec4(0.1, 0.12, 0.16, 0.9);
    return dark ? glm::vec4(0.62, 0.66, 0.72, 0.55) : glm::vec4(0.2, 0.22, 0.26, 0.7);
}

float outline_width(SurfaceRole role) {
    return role == SurfaceRole::emitter ? 2.f : role == SurfaceRole::blocker ? 1.5f : 1.f;
}

void draw_outlines(const LinePass &lines, const Frame &frame, const GpuSnapshot &gpu) {
    LineStyles styles;
    for (const SurfaceRole role : {SurfaceRole::reflector, SurfaceRole::emitter, SurfaceRole::blocker})
        styles.set(styles::outline(role), outline_colour(role, frame.look.theme), outline_width(role));
    lines.draw(frame, gpu.outlines, styles, 1.2e-3f);
}

} // namespace penumbra
