#include "render/gl/program.hpp"

#include <epoxy/gl.h>

#include <string>
#include <vector>

namespace trembler::render {

namespace {

GlShader compile(std::string_view name, GLenum kind, std::initializer_list<std::string_view> pieces) {
    std::vector<char const*> texts;
    std::vector<GLint> lengths;
    for (auto const piece : pieces) {
        texts.push_back(piece.data());
        lengths.push_back(static_cast<GLint>(piece.size()));
    }
    GlShader shader(glCreateShader(kind));
    glShaderSource(shader.name(), static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        throw RenderError("The graphics driver does not accept the shader '" + std::string(name) +
                          "': " + log);
    }
    return shader;
}

} // namespace

Program::Program(std::string_view name, std::initializer_list<std::string_view> vertex,
                 std::initializer_list<std::string_view> fragment) {
    auto const vertexShader = compile(name, GL_VERTEX_SHADER, vertex);
    auto const fragmentShader = compile(name, GL_FRAGMENT_SHADER, fragment);
    program_ = GlProgram(glCreateProgram());
    glAttachShader(program_.name(), vertexShader.name());
    glAttachShader(program_.name(), fragmentShader.name());
    glLinkProgram(program_.name());
    GLint linked = GL_FALSE;
    glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        std::string log(4096, '\0');
        GLsizei length = 0;
        glGetProgramInfoLog(program_.name(), static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        throw RenderError("The graphics driver cannot link the shaders '" + std::string(name) + "': " + log);
    }
}

void Program::use() const {
    glUseProgram(program_.name());
}

void Program::set(char const* uniform, int value) const {
    glUniform1i(glGetUniformLocation(program_.name(), uniform), value);
}

void Program::set(char const* uniform, float value) const {
    glUniform1f(glGetUniformLocation(program_.name(), uniform), value);
}

void Program::set(char const* uniform, float x, float y) const {
    glUniform2f(glGetUniformLocation(program_.name(), uniform), x, y);
}

void Program::set(char const* uniform, float x, float y, float z) const {
    glUniform3f(glGetUniformLocation(program_.name(), uniform), x, y, z);
}

} // namespace trembler::render
