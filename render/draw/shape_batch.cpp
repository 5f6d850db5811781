#include "render/draw/shape_batch.hpp"

#include "render/draw/palette.hpp"
#include "render/draw/shaders.hpp"

#include <epoxy/gl.h>

#include <cstddef>

namespace trembler::render {

namespace {

/// OpenGL takes a place in the bound buffer as a pointer.
void const* inBuffer(std::size_t offset) {
    return reinterpret_cast<void const*>(offset); // NOLINT(performance-no-int-to-ptr)
}

void floats(GLuint location, GLint count, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, sizeof(Instance), inBuffer(offset));
    glVertexAttribDivisor(location, 1);
}

void colour(GLuint location, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Instance), inBuffer(offset));
    glVertexAttribDivisor(location, 1);
}

void setColour(Program const& program, char const* uniform, Colour value) {
    program.set(uniform, static_cast<float>(value.red) / 255.F, static_cast<float>(value.green) / 255.F,
                static_cast<float>(value.blue) / 255.F);
}

} // namespace

ShapeBatch::ShapeBatch()
    : program_(
          "shapes", {shaders::shapeVertex},
          {shaders::shapeCommon, shaders::shapeDistance, shaders::shapeMaterial, shaders::shapeFragment}),
      layout_(makeVertexArray()), instances_(makeBuffer()), corners_(makeBuffer()),
      cornerView_(makeTexture()) {
    glBindVertexArray(layout_.name());
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    floats(0, 2, offsetof(Instance, centre));
    floats(1, 2, offsetof(Instance, axis));
    floats(2, 2, offsetof(Instance, half));
    floats(3, 2, offsetof(Instance, radius));
    floats(4, 4, offsetof(Instance, params));
    colour(5, offsetof(Instance, colour));
    colour(6, offsetof(Instance, edge));
    glEnableVertexAttribArray(7);
    glVertexAttribIPointer(7, 4, GL_UNSIGNED_BYTE, sizeof(Instance), inBuffer(offsetof(Instance, kind)));
    glVertexAttribDivisor(7, 1);
    floats(8, 1, offsetof(Instance, grain));
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void ShapeBatch::draw(std::span<Instance const> shapes, std::span<Corner const> corners,
                      BatchView const& view) const {
    if (shapes.empty()) {
        return;
    }
    // A fresh store every time, so that the driver need not wait for the last frame to be done with the old
    // one.
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shapes.size_bytes()), shapes.data(),
                 GL_STREAM_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    Corner const none{};
    auto const sent = corners.empty() ? std::span<Corner const>(&none, 1) : corners;
    glBindBuffer(GL_TEXTURE_BUFFER, corners_.name());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(sent.size_bytes()), sent.data(), GL_STREAM_DRAW);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_BUFFER, cornerView_.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RG32F, corners_.name());

    program_.use();
    program_.set("u_corners", 0);
    program_.set("u_viewHalf", view.halfWidth, view.halfHeight);
    program_.set("u_pixel", view.metresPerPixel);
    program_.set("u_ui", view.uiScale);
    program_.set("u_time", view.time);
    setColour(program_, "u_accent", palette::accent);
    setColour(program_, "u_warning", palette::warning);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(layout_.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(shapes.size()));
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
    glUseProgram(0);
}

} // namespace trembler::render
