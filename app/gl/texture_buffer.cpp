#include "gl/texture_buffer.h"

namespace penumbra::gl {

void TextureBuffer::upload(std::span<const glm::vec4> texels) {
    size_ = static_cast<int>(texels.size());
    static constexpr glm::vec4 nothing{0};
    if (texels.empty()) // a buffer texture wants a buffer with storage
        texels = {&nothing, 1};
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_.name());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(texels.size_bytes()), texels.data(), GL_STATIC_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_.name());
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
}

void TextureBuffer::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_BUFFER, texture_.name());
}

} // namespace penumbra::gl
