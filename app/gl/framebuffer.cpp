#include "gl/framebuffer.h"

#include "core/error.h"

#include <algorithm>
#include <string>

namespace penumbra::gl {

Framebuffer::Framebuffer(int width, int height, Colour colour, int samples) : width_(width), height_(height) {
    GLint most_samples = 1, largest = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (width < 1 || height < 1 || width > largest || height > largest)
        throw Unavailable("a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                          " pixels cannot be drawn; each side must be from 1 to " + std::to_string(largest));
    const GLsizei n = samples > 1 ? std::min(samples, static_cast<int>(most_samples)) : 0;
    glBindRenderbuffer(GL_RENDERBUFFER, colour_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, n, colour == Colour::srgb8 ? GL_RGBA8 : GL_RGBA32F, width,
                                     height);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, n, GL_DEPTH_COMPONENT24, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    bind();
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Unavailable("the graphics driver cannot draw a picture of " + std::to_string(width) + "x" +
                          std::to_string(height) + " pixels");
}

void Framebuffer::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name()); }

void Framebuffer::resolve(const Framebuffer &from) const { resolve(from, 0, 0, width_, height_); }

void Framebuffer::resolve(const Framebuffer &from, int x, int y, int width, int height) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
    glBlitFramebuffer(x, y, x + width, y + height, x, y, x + width, y + height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    bind();
}

} // namespace penumbra::gl
