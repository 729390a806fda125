// Pictures of any size from framebuffers of a size that every driver has.
#pragma once

#include "capture.h"
#include "render/pane_renderer.h"

#include <glm/glm.hpp>

#include <functional>

namespace penumbra {

struct Tiling {
    int width = 1, height = 1; ///< of the picture [pixels]
    int supersample = 1;       ///< samples to a pixel's side
    int largest = 2048;        ///< side of a tile [samples]; made smaller where the driver asks for it
    bool transparent = false;  ///< the image has alpha; what is drawn is multiplied by its own
    glm::vec4 background{0};   ///< sRGB
};

/// Calls both for every tile, whose place in the picture [samples, from the upper left] they are told: `draw_smooth`
/// into a framebuffer of that tile with four samples a pixel, then `draw_over` on what these came to. Tiles begin at
/// even places, counted from the lower left, so that derivatives on the screen are taken over the same pixels as in the
/// whole. Each pixel becomes the mean of its samples' light, weighted by alpha. Throws Unavailable where the driver
/// cannot make a framebuffer.
Image draw_in_tiles(const Tiling &tiling, const std::function<void(const PixelRect &)> &draw_smooth,
                    const std::function<void(const PixelRect &)> &draw_over);

} // namespace penumbra
