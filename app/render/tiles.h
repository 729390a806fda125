// Pictures of any size from framebuffers of a size that every driver has.
#pragma once

#include "capture.h"
#include "render/pane_renderer.h"

#include <glm/glm.hpp>

#include <functional>
#include <memory>

namespace penumbra {

struct Tiling {
    int width = 1, height = 1; ///< of the picture [pixels]
    int supersample = 1;       ///< samples to a pixel's side
    int largest = 1024;        ///< side of a tile [samples]; made smaller where the driver asks for it
    bool transparent = false;  ///< the image has alpha; what is drawn is multiplied by its own
    glm::vec4 background{0};   ///< sRGB
};

/// A picture that is drawn tile by tile. Tiles begin at even places, counted from the lower left, so that derivatives on the
/// screen are taken over the same pixels as in the whole. Each pixel becomes the mean of its samples' light, weighted by
/// alpha.
class TiledDrawing {
public:
    /// Throws Unavailable where the driver cannot make a framebuffer.
    explicit TiledDrawing(const Tiling &tiling);
    ~TiledDrawing();
    TiledDrawing(const TiledDrawing &) = delete;
    TiledDrawing &operator=(const TiledDrawing &) = delete;

    /// The next tile, whose place in the picture [samples, from the upper left] both are told: `draw_smooth` draws into a
    /// framebuffer of that tile with four samples a pixel, then `draw_over` on what these came to. False where there is none
    /// left.
    bool draw_tile(const std::function<void(const PixelRect &)> &draw_smooth,
                   const std::function<void(const PixelRect &)> &draw_over);
    double share() const; ///< of the tiles that are drawn
    Image take() &&;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace penumbra
