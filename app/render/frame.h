// What all passes of one pane need to know. Space is the scene's, centred and scaled to unit size.
#pragma once

#include "gl/program.h"
#include "render/look.h"

#include <glm/glm.hpp>

namespace penumbra {

struct Frame {
    glm::mat4 view{1}, projection{1};
    glm::vec3 eye{0};
    glm::vec2 viewport{1}; ///< pixels
    glm::vec2 origin{0};   ///< where the framebuffer lies in the pane [pixels, from the lower left]
    float near = 0.01f;    ///< distance of the near plane
    float pixel = 0.001f;  ///< space to a pixel at the depth of the target
    float scale = 1;       ///< PixelScale
    Look look;
    Range range;

    /// Sets what shaders/space.glsl asks for; the surfaces' records are on texture unit 0.
    void set_space(const gl::Program &program) const {
        program.set("surfaces", 0);
        program.set("view", view);
        program.set("projection", projection);
        program.set("eye", eye);
    }
};

} // namespace penumbra
