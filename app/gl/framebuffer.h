// A picture off the screen: colour and depth.
#pragma once

#include "gl/handle.h"

namespace penumbra::gl {

class Framebuffer {
public:
    enum class Colour { srgb8, float32 };

    /// `samples` a pixel, 1 for none; `srgb8` holds values that are sRGB already (nothing is converted). Throws
    /// Unavailable when the driver cannot make one of this size.
    Framebuffer(int width, int height, Colour colour, int samples);

    void bind() const;
    /// Averages the samples of `from`, of the same size, into this one.
    void resolve(const Framebuffer &from) const;
    /// The same in a rectangle alone; x, y count from the lower left corner.
    void resolve(const Framebuffer &from, int x, int y, int width, int height) const;
    int width() const { return width_; }
    int height() const { return height_; }

private:
    int width_, height_;
    FramebufferName framebuffer_;
    Renderbuffer colour_, depth_;
};

} // namespace penumbra::gl
