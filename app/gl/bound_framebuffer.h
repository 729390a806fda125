// Drawing off the screen leaves what a window drew into as it was.
#pragma once

#include <epoxy/gl.h>

namespace penumbra::gl {

/// Binds again, at its end, the framebuffers that were bound when it was made.
class BoundFramebuffer {
public:
    BoundFramebuffer() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    }
    ~BoundFramebuffer() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    }
    BoundFramebuffer(const BoundFramebuffer &) = delete;
    BoundFramebuffer &operator=(const BoundFramebuffer &) = delete;

private:
    GLint draw_ = 0, read_ = 0;
};

} // namespace penumbra::gl
