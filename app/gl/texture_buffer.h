// An array of 4-float records that shaders read by index.
#pragma once

#include "gl/handle.h"

#include <glm/glm.hpp>

#include <span>

namespace penumbra::gl {

class TextureBuffer {
public:
    /// Replaces what it holds.
    void upload(std::span<const glm::vec4> texels);
    /// Makes it the samplerBuffer of this texture unit.
    void bind(int unit) const;
    int size() const { return size_; } ///< texels

private:
    Buffer buffer_;
    Texture texture_;
    int size_ = 0;
};

} // namespace penumbra::gl
