// The panes' scenes, drawn only when what they show has changed and kept off the screen in between, so that a moving
// mouse costs no more than the interface.
#pragma once

#include "app_state.h"
#include "panels/arrangement.h"
#include "render/pane_renderer.h"

#include <array>
#include <memory>

namespace penumbra {

class PaneCanvas {
public:
    PaneCanvas();
    ~PaneCanvas();
    PaneCanvas(const PaneCanvas &) = delete;
    PaneCanvas &operator=(const PaneCanvas &) = delete;

    /// Draws into the default framebuffer, of this size [pixels]; a look for each pane; `pixel_ratio` is pixels to a screen coordinate.
    /// While the view is `moving` what has changed is drawn as a draft, with one sample a pixel, in half the time: lines
    /// are as smooth, borders of surfaces less so. Returns how many panes had to be drawn anew.
    int draw(const AppState &state, const std::array<Look, 4> &looks, const Arrangement &arrangement, int width, int height,
             double pixel_ratio, bool moving);
    /// Whether a pane shows a draft, and should be drawn once more when the view rests.
    bool draft() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace penumbra
