// Owns the name of one GL object.
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace penumbra::gl {

/// Traits has static create() and destroy(GLuint). Moved, never copied; destroyed while the context is current.
template <class Traits>
class Handle {
public:
    Handle() : name_(Traits::create()) {}
    ~Handle() {
        if (name_ != 0)
            Traits::destroy(name_);
    }
    Handle(Handle &&other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle &operator=(Handle &&other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    GLuint name() const { return name_; }

private:
    GLuint name_;
};

struct BufferTraits {
    static GLuint create() {
        GLuint n = 0;
        glGenBuffers(1, &n);
        return n;
    }
    static void destroy(GLuint n) { glDeleteBuffers(1, &n); }
};
struct TextureTraits {
    static GLuint create() {
        GLuint n = 0;
        glGenTextures(1, &n);
        return n;
    }
    static void destroy(GLuint n) { glDeleteTextures(1, &n); }
};
struct VertexArrayTraits {
    static GLuint create() {
        GLuint n = 0;
        glGenVertexArrays(1, &n);
        return n;
    }
    static void destroy(GLuint n) { glDeleteVertexArrays(1, &n); }
};
struct FramebufferTraits {
    static GLuint create() {
        GLuint n = 0;
        glGenFramebuffers(1, &n);
        return n;
    }
    static void destroy(GLuint n) { glDeleteFramebuffers(1, &n); }
};
struct RenderbufferTraits {
    static GLuint create() {
        GLuint n = 0;
        glGenRenderbuffers(1, &n);
        return n;
    }
    static void destroy(GLuint n) { glDeleteRenderbuffers(1, &n); }
};

using Buffer = Handle<BufferTraits>;
using Texture = Handle<TextureTraits>;
using VertexArray = Handle<VertexArrayTraits>;
using FramebufferName = Handle<FramebufferTraits>;
using Renderbuffer = Handle<RenderbufferTraits>;

} // namespace penumbra::gl
