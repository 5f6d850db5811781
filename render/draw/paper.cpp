#include "render/draw/paper.hpp"

#include "render/draw/palette.hpp"
#include "render/draw/shaders.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace trembler::render {

namespace {

/// Lines closer than this (pixels at UI scale 1) are not drawn.
constexpr double closestLines = 7;

/// Constant from the scale at which the second coarsest set appears, so that the coarsest can go without a
/// jump.
float strengthAt(double pixels) {
    double const decades = std::log10(std::min(pixels / closestLines, 50.0));
    return decades > 0 ? static_cast<float>(0.80 * decades / (decades + 0.8)) : 0.F;
}

} // namespace

std::array<Ruling, 5> rulingsFor(double pixelsPerMetre, float uiScale) {
    double const unit = pixelsPerMetre / static_cast<double>(uiScale);
    double const finest = std::pow(10.0, std::ceil(std::log10(closestLines / unit)));
    std::array<Ruling, 5> rulings;
    std::array const multiples{1.0, 5.0, 10.0, 50.0, 100.0};
    for (std::size_t i = 0; i < rulings.size(); ++i) {
        double const spacing = multiples[i] * finest;
        rulings[i] = {spacing, strengthAt(spacing * unit)};
    }
    return rulings;
}

Paper::Paper()
    : program_("paper", {shaders::paperVertex}, {shaders::paperFragment}), layout_(makeVertexArray()) {}

void Paper::draw(Camera const& camera, float uiScale) const {
    auto const rulings = rulingsFor(camera.pixelsPerMetre, uiScale);
    double const coarse = rulings.back().spacing * camera.pixelsPerMetre;
    // Only the crossing nearest to the view goes to the card: far from the origin 32 bits would not be
    // enough.
    auto const origin = [&](double centre, int pixels) {
        return static_cast<float>(0.5 * pixels - std::remainder(centre * camera.pixelsPerMetre, coarse));
    };
    auto const channel = [](std::uint8_t value) { return static_cast<float>(value) / 255.F; };
    program_.use();
    program_.set("u_paper", channel(palette::paper.red), channel(palette::paper.green),
                 channel(palette::paper.blue));
    program_.set("u_grid", channel(palette::grid.red), channel(palette::grid.green),
                 channel(palette::grid.blue));
    program_.set("u_size", static_cast<float>(camera.viewport.width),
                 static_cast<float>(camera.viewport.height));
    program_.set("u_origin", origin(camera.centre.x, camera.viewport.width),
                 origin(camera.centre.y, camera.viewport.height));
    for (std::size_t i = 0; i < rulings.size(); ++i) {
        program_.set(("u_rulings[" + std::to_string(i) + "]").c_str(),
                     static_cast<float>(rulings[i].spacing * camera.pixelsPerMetre), rulings[i].strength);
    }
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
