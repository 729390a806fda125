#include "window/pane_canvas.h"

#include "gl/framebuffer.h"
#include "truth_verbs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace penumbra {

namespace {

constexpr int samples = 4; // what llvmpipe offers at most, at twice the time of one

/// All that a pane's picture depends on.
struct Shown {
    std::uint64_t version = 0;
    bool reconstructed = false;
    std::shared_ptr<const ErrorMap> errors; ///< null: the light is shown
    Camera camera;
    Look look;
    PixelRect rect;
    bool draft = false; ///< of one sample a pixel
};

bool same(const PixelRect &a, const PixelRect &b) {
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}
bool same(const Shown &a, const Shown &b) {
    return a.version == b.version && a.errors == b.errors && a.camera == b.camera && a.look == b.look &&
           same(a.rect, b.rect);
}

PixelRect pixels(const WindowRect &r, double ratio) {
    const auto at = [&](float x) { return static_cast<int>(std::lround(static_cast<double>(x) * ratio)); };
    return {at(r.x), at(r.y), at(r.x + r.width) - at(r.x), at(r.y + r.height) - at(r.y)};
}

} // namespace

struct PaneCanvas::Parts {
    std::array<PaneRenderer, 4> renderers;
    std::array<std::optional<Shown>, 4> shown;
    std::optional<gl::Framebuffer> sampled;
    std::array<std::optional<gl::Framebuffer>, 2> kept; ///< the second for the second of two panes that share a place
    Theme theme = Theme::dark;
    std::vector<PixelRect> rects; ///< of the panes; between them are lines that no pane draws
    PixelRect strip{};

    void resize(int width, int height) {
        if (kept[0] && kept[0]->width() == width && kept[0]->height() == height)
            return;
        sampled.emplace(width, height, gl::Framebuffer::Colour::srgb8, samples);
        kept[0].emplace(width, height, gl::Framebuffer::Colour::srgb8, 1);
        kept[1].reset();
        clear();
    }
    /// Where a pane's picture is kept: whole, so that nothing is drawn anew when more or less of it is seen.
    gl::Framebuffer &canvas_of(std::size_t i, bool shares_a_place) {
        if (!shares_a_place || i == 0)
            return *kept[0];
        if (!kept[1]) {
            kept[1].emplace(kept[0]->width(), kept[0]->height(), gl::Framebuffer::Colour::srgb8, 1);
            clear_colour(*kept[1]);
        }
        return *kept[1];
    }
    /// Panes that have become smaller leave nothing of what they showed where the legend stands now.
    void clear_strip(const PixelRect &now, int height) {
        if (same(strip, now))
            return;
        strip = now;
        glEnable(GL_SCISSOR_TEST);
        glScissor(now.x, height - now.y - now.height, now.width, now.height);
        clear_colour(*kept[0]);
        glDisable(GL_SCISSOR_TEST);
    }
    /// Whether the pane has a picture of errors that would still be right but for the step.
    bool shows_errors(std::size_t i, const PixelRect &rect, const AppState &state) const {
        return shown[i] && shown[i]->errors && same(shown[i]->rect, rect) && shown[i]->camera == state.camera_of(static_cast<int>(i)) &&
               !state.truth.halted;
    }
    void clear() {
        for (const auto &canvas : kept)
            if (canvas)
                clear_colour(*canvas);
        shown = {};
    }
    void clear_colour(const gl::Framebuffer &canvas) const {
        canvas.bind();
        const float level = theme == Theme::dark ? 0.16f : 0.8f; // of the lines between panes
        glClearColor(level, level, level, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
};

PaneCanvas::PaneCanvas() : parts_(std::make_unique<Parts>()) {}
PaneCanvas::~PaneCanvas() = default;

int PaneCanvas::draw(const AppState &state, const std::array<Look, 4> &looks, const Arrangement &arrangement, int width, int height,
                     double pixel_ratio, bool moving) {
    Parts &p = *parts_;
    p.resize(width, height);
    std::vector<PixelRect> rects;
    for (const WindowRect &pane : arrangement.pane)
        rects.push_back(pixels(pane, pixel_ratio));
    if (p.theme != looks[0].theme || !std::ranges::equal(p.rects, rects, [](const auto &a, const auto &b) { return same(a, b); })) {
        p.theme = looks[0].theme;
        p.rects = rects;
        p.clear();
    }
    p.clear_strip(pixels(arrangement.legend, pixel_ratio), height);
    const bool shares_a_place = arrangement.place.size() < arrangement.pane.size();
    int drawn = 0;
    // A panel may have changed the layout in this frame; it is arranged in the next.
    for (std::size_t i = 0; i < std::min<std::size_t>(n_panes(state.layout), arrangement.pane.size()); ++i) {
        const int pane = static_cast<int>(i);
        const Look &look = looks[i];
        const auto snapshot = state.shown_snapshot(pane);
        if (!snapshot)
            continue; // what was there stays until the new solution is ready
        if (arrangement.part[i].width <= 0 && (moving || look.difference))
            continue; // else it is drawn, at rest, to be there at once when it is asked for
        const Camera &camera = state.camera_of(pane);
        if (state.awaits_reconstruction(pane) && p.shown[i] && p.shown[i]->reconstructed)
            continue;
        const bool wrong = look.shading == Shading::error && look.error_range;
        const auto errors = wrong ? errors_of(state, pane) : nullptr;
        if (wrong && !errors && p.shows_errors(i, rects[i], state))
            continue; // until those of this step are measured
        const Shown now{
            snapshot->version, snapshot->reconstructed, errors, camera, look, rects[i], moving};
        if (p.shown[i] && same(*p.shown[i], now) && (moving || !p.shown[i]->draft))
            continue;
        const gl::Framebuffer &canvas = p.canvas_of(i, shares_a_place);
        (moving ? canvas : *p.sampled).bind();
        p.renderers[i].upload(snapshot, errors);
        p.renderers[i].draw(camera, look, now.rect, height, {pixel_ratio * state.ui_scale});
        if (!moving)
            canvas.resolve(*p.sampled, now.rect.x, height - now.rect.y - now.rect.height, now.rect.width, now.rect.height);
        p.shown[i] = now;
        ++drawn;
    }
    const auto show = [&](const gl::Framebuffer &canvas, const PixelRect &part) {
        const int bottom = height - part.y - part.height, right = part.x + part.width, top = height - part.y;
        canvas.bind();
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBlitFramebuffer(part.x, bottom, right, top, part.x, bottom, right, top, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    };
    show(*p.kept[0], {0, 0, width, height});
    if (shares_a_place && p.kept[1] && arrangement.part[1].width > 0)
        show(*p.kept[1], pixels(arrangement.part[1], pixel_ratio));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return drawn;
}

bool PaneCanvas::draft() const {
    return std::ranges::any_of(parts_->shown, [](const auto &shown) { return shown && shown->draft; });
}

} // namespace penumbra
