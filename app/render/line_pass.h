// Segments of constant width on the screen, in up to sixteen styles.
#pragma once

#include "gl/program.h"
#include "gl/texture_buffer.h"
#include "render/frame.h"

#include <array>

namespace penumbra {

struct LineStyles {
    std::array<glm::vec4, 16> colours{}; ///< sRGB and opacity
    std::array<glm::vec4, 16> strokes{}; ///< width, dash period [pixels; 0: solid], part that is drawn, extra width

    void set(int style, const glm::vec4 &colour, float width, float dash = 0, float drawn = 1);
};

class LinePass {
public:
    LinePass();
    /// Blends `segments` (layout: shaders/line.vert) over what is there, hidden by what stands before them; surfaces'
    /// records are on unit 0. With a `casing`, every line is first drawn in that colour, a pixel wider on each side,
    /// so that it stands out from any ground. `lift`: part of the way to the eye.
    void draw(const Frame &frame, const gl::TextureBuffer &segments, LineStyles styles, float lift,
              const glm::vec4 &casing = glm::vec4(0)) const;

private:
    gl::Program program_;
};

} // namespace penumbra
