#include "render/draw/paper.hpp"

#include "render/draw/palette.hpp"
#include "render/draw/shaders.hpp"

#include <epoxy/gl.h>

#include <algorithm>

namespace trembler::render {

namespace {

/// Lines closer than this (pixels at UI scale 1) are not drawn; ten times as far apart they are at full strength.
constexpr double closestLines = 8;

} // namespace

Ruling rulingFor(double pixelsPerMetre, float uiScale) {
    double const closest = closestLines * static_cast<double>(uiScale) / pixelsPerMetre;
    double const exponent = std::ceil(std::log10(closest));
    double const fine = std::pow(10.0, exponent);
    double const fadedIn = std::clamp(exponent - std::log10(closest), 0.0, 1.0);
    return {fine, static_cast<float>(fadedIn)};
}

Paper::Paper() : program_("paper", {shaders::paperVertex}, {shaders::paperFragment}), layout_(makeVertexArray()) {}

void Paper::draw(Camera const& camera, float uiScale) const {
    auto const ruling = rulingFor(camera.pixelsPerMetre, uiScale);
    double const fine = ruling.fine * camera.pixelsPerMetre;
    double const coarse = 100 * fine;
    // Only the crossing nearest to the view goes to the card: far from the origin 32 bits would not be enough.
    auto const origin = [&](double centre, int pixels) {
        return static_cast<float>(0.5 * pixels - std::remainder(centre * camera.pixelsPerMetre, coarse));
    };
    auto const channel = [](std::uint8_t value) { return static_cast<float>(value) / 255.F; };
    program_.use();
    program_.set("u_paper", channel(palette::paper.red), channel(palette::paper.green), channel(palette::paper.blue));
    program_.set("u_grid", channel(palette::grid.red), channel(palette::grid.green), channel(palette::grid.blue));
    program_.set("u_size", static_cast<float>(camera.viewport.width), static_cast<float>(camera.viewport.height));
    program_.set("u_origin", origin(camera.centre.x, camera.viewport.width),
                 origin(camera.centre.y, camera.viewport.height));
    program_.set("u_spacing", static_cast<float>(fine), static_cast<float>(10 * fine), static_cast<float>(coarse));
    // Each ruling takes over the strength of the next coarser one while the zoom runs through a decade, so nothing jumps.
    float const fade = ruling.fineStrength;
    program_.set("u_strength", 0.26F * fade, 0.26F + 0.22F * fade, 0.48F + 0.12F * fade);
    program_.set("u_thick", std::max(1.F, std::floor(uiScale + 0.25F)));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glBindVertexArray(layout_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glUseProgram(0);
}

} // namespace trembler::render
