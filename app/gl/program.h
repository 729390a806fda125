// A linked pair of shaders made of embedded files.
#pragma once

#include <epoxy/gl.h>
#include <glm/glm.hpp>

#include <initializer_list>
#include <span>
#include <string_view>

namespace penumbra::gl {

class Program {
public:
    /// Each stage is the concatenation of files under shaders/ ("patch.glsl"), with `#version 410 core` put before.
    /// Throws Unavailable with the file names and the driver's message when it does not compile or link.
    Program(std::initializer_list<std::string_view> vertex, std::initializer_list<std::string_view> fragment);
    ~Program();
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;

    void use() const { glUseProgram(name_); }

    // Of the program in use. A uniform that the shader does not have is left alone, as GL does.
    void set(const char *uniform, int value) const;
    void set(const char *uniform, float value) const;
    void set(const char *uniform, const glm::vec2 &value) const;
    void set(const char *uniform, const glm::vec3 &value) const;
    void set(const char *uniform, const glm::vec4 &value) const;
    void set(const char *uniform, const glm::mat4 &value) const;
    void set(const char *uniform, std::span<const glm::vec4> values) const;

private:
    GLuint name_ = 0;
};

} // namespace penumbra::gl
