#include "render/draw/shape_batch.hpp"

#include "render/draw/palette.hpp"
#include "render/draw/shaders.hpp"

#include <epoxy/gl.h>

#include <cstddef>
#include <string>

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
    : layout_(makeVertexArray()), instances_(makeBuffer()), corners_(makeBuffer()),
      cornerView_(makeTexture()) {
    // A driver that cannot compile the shaders should fail now and not in the middle of a game.
    (void)programFor({.shaded = true});
}

ShapeBatch::Look ShapeBatch::lookOf(Instance const& shape) {
    if (shape.effect == effectGlow || shape.effect == effectShadow) {
        return {.light = true, .kind = shape.kind};
    }
    bool const shaded = shape.effect == effectSolid;
    bool const marked = (shape.flags & (flagSelected | flagGhost | flagForbidden | flagHovered)) != 0;
    bool const known = shaded && shape.pattern < patternCount;
    return {.shaded = shaded,
            .marked = marked,
            .pattern = known ? shape.pattern : std::uint8_t{0},
            .kind = shape.kind};
}

std::size_t ShapeBatch::indexOf(Look const& look) {
    std::size_t const paint = look.light ? 0U : (look.shaded ? 2U + look.pattern : 1U);
    return (paint * 2 + (look.marked ? 1U : 0U)) * kindCount + look.kind;
}

Program const& ShapeBatch::programFor(Look const& look) {
    auto& program = programs_[indexOf(look)];
    if (!program) {
        auto const define = [](char const* name, int value) {
            return std::string("#define ") + name + " " + std::to_string(value) + "\n";
        };
        std::string const head = "#version 330 core\n" + define("LIGHT", look.light ? 1 : 0) +
                                 define("SHADED", look.shaded ? 1 : 0) +
                                 define("MARKED", look.marked ? 1 : 0) + define("PATTERN", look.pattern) +
                                 define("KIND", look.kind);
        program.emplace("shapes", std::initializer_list<std::string_view>{shaders::shapeVertex},
                        std::initializer_list<std::string_view>{head, shaders::shapeCommon,
                                                                shaders::shapeDistance, shaders::shapePattern,
                                                                shaders::shapeFragment});
    }
    return *program;
}

void ShapeBatch::setView(Program const& program, BatchView const& view) const {
    program.use();
    program.set("u_corners", 0);
    program.set("u_viewHalf", view.halfWidth, view.halfHeight);
    program.set("u_pixel", view.metresPerPixel);
    program.set("u_ui", view.uiScale);
    program.set("u_time", view.time);
    program.set("u_flatAt", view.flatAt[0], view.flatAt[1]);
    program.set("u_flatBy", view.flatBy[0], view.flatBy[1]);
    setColour(program, "u_accent", palette::accent);
    setColour(program, "u_warning", palette::warning);
}

void ShapeBatch::startAt(std::size_t first) {
    std::size_t const start = first * sizeof(Instance);
    floats(0, 2, start + offsetof(Instance, centre));
    floats(1, 2, start + offsetof(Instance, axis));
    floats(2, 2, start + offsetof(Instance, half));
    floats(3, 2, start + offsetof(Instance, radius));
    floats(4, 4, start + offsetof(Instance, params));
    colour(5, start + offsetof(Instance, colour));
    colour(6, start + offsetof(Instance, edge));
    glEnableVertexAttribArray(7);
    glVertexAttribIPointer(7, 4, GL_UNSIGNED_BYTE, sizeof(Instance),
                           inBuffer(start + offsetof(Instance, kind)));
    glVertexAttribDivisor(7, 1);
    floats(8, 1, start + offsetof(Instance, grain));
}

void ShapeBatch::draw(std::span<Instance const> shapes, std::span<Corner const> corners,
                      BatchView const& view) {
    if (shapes.empty()) {
        return;
    }
    // A new store in each frame, so that the driver need not wait until the last frame is drawn from the old
    // one.
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shapes.size_bytes()), shapes.data(),
                 GL_STREAM_DRAW);
    Corner const none{};
    auto const sent = corners.empty() ? std::span<Corner const>(&none, 1) : corners;
    glBindBuffer(GL_TEXTURE_BUFFER, corners_.name());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(sent.size_bytes()), sent.data(), GL_STREAM_DRAW);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_BUFFER, cornerView_.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RG32F, corners_.name());

    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(layout_.name());
    std::array<bool, lookCount> set{};
    for (std::size_t first = 0; first < shapes.size();) {
        auto const look = lookOf(shapes[first]);
        auto next = first + 1;
        while (next < shapes.size() && lookOf(shapes[next]) == look) {
            ++next;
        }
        auto const& program = programFor(look);
        if (auto& done = set[indexOf(look)]; !done) {
            setView(program, view);
            done = true;
        } else {
            program.use();
        }
        startAt(first);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(next - first));
        first = next;
    }
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
    glDisable(GL_BLEND);
    glBindTexture(GL_TEXTURE_BUFFER, 0);
    glBindBuffer(GL_TEXTURE_BUFFER, 0);
    glUseProgram(0);
}

} // namespace trembler::render
