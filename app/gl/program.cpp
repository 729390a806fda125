#include "gl/program.h"

#include "core/error.h"
#include "embedded.h"

#include <glm/gtc/type_ptr.hpp>

#include <string>

namespace penumbra::gl {
namespace {

std::string log_of(GLuint object, bool is_program) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    if (is_program)
        glGetProgramInfoLog(object, static_cast<GLsizei>(log.size()), &length, log.data());
    else
        glGetShaderInfoLog(object, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return log;
}

GLuint compile(GLenum stage, std::initializer_list<std::string_view> files) {
    std::string source = "#version 410 core\n", names;
    for (const std::string_view file : files) {
        source += embedded("shaders/" + std::string(file));
        names += ' ';
        names += file;
    }
    const GLuint shader = glCreateShader(stage);
    const char *text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok == 0) {
        const std::string log = log_of(shader, false);
        glDeleteShader(shader);
        throw Unavailable("the graphics driver refused the shader" + names + ": " + log);
    }
    return shader;
}

} // namespace

Program::Program(std::initializer_list<std::string_view> vertex, std::initializer_list<std::string_view> fragment)
    : name_(glCreateProgram()) {
    for (const GLuint shader : {compile(GL_VERTEX_SHADER, vertex), compile(GL_FRAGMENT_SHADER, fragment)}) {
        glAttachShader(name_, shader);
        glDeleteShader(shader); // lives on until the program goes
    }
    glLinkProgram(name_);
    GLint ok = 0;
    glGetProgramiv(name_, GL_LINK_STATUS, &ok);
    if (ok == 0)
        throw Unavailable("the graphics driver refused to link " + std::string(*(fragment.end() - 1)) + ": " +
                          log_of(name_, true));
}

Program::~Program() { glDeleteProgram(name_); }

void Program::set(const char *uniform, int value) const { glUniform1i(glGetUniformLocation(name_, uniform), value); }
void Program::set(const char *uniform, float value) const { glUniform1f(glGetUniformLocation(name_, uniform), value); }
void Program::set(const char *uniform, const glm::vec2 &value) const {
    glUniform2fv(glGetUniformLocation(name_, uniform), 1, glm::value_ptr(value));
}
void Program::set(const char *uniform, const glm::vec3 &value) const {
    glUniform3fv(glGetUniformLocation(name_, uniform), 1, glm::value_ptr(value));
}
void Program::set(const char *uniform, const glm::vec4 &value) const {
    glUniform4fv(glGetUniformLocation(name_, uniform), 1, glm::value_ptr(value));
}
void Program::set(const char *uniform, const glm::mat4 &value) const {
    glUniformMatrix4fv(glGetUniformLocation(name_, uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(const char *uniform, std::span<const glm::vec4> values) const {
    glUniform4fv(glGetUniformLocation(name_, uniform), static_cast<GLsizei>(values.size()),
                 glm::value_ptr(values.front()));
}

} // namespace penumbra::gl
