#include "render/gl/handle.hpp"

#include <epoxy/gl.h>

namespace trembler::render {

void deleteBuffer(unsigned name) {
    glDeleteBuffers(1, &name);
}
void deleteVertexArray(unsigned name) {
    glDeleteVertexArrays(1, &name);
}
void deleteTexture(unsigned name) {
    glDeleteTextures(1, &name);
}
void deleteFramebuffer(unsigned name) {
    glDeleteFramebuffers(1, &name);
}
void deleteProgram(unsigned name) {
    glDeleteProgram(name);
}
void deleteShader(unsigned name) {
    glDeleteShader(name);
}

GlBuffer makeBuffer() {
    unsigned name = 0;
    glGenBuffers(1, &name);
    return GlBuffer(name);
}

GlVertexArray makeVertexArray() {
    unsigned name = 0;
    glGenVertexArrays(1, &name);
    return GlVertexArray(name);
}

GlTexture makeTexture() {
    unsigned name = 0;
    glGenTextures(1, &name);
    return GlTexture(name);
}

GlFramebuffer makeFramebuffer() {
    unsigned name = 0;
    glGenFramebuffers(1, &name);
    return GlFramebuffer(name);
}

} // namespace trembler::render
