// The vertex shader of all shapes: a quad that is just large enough for the shape and its outline, glow or
// shadow.
#include "render/draw/shaders.hpp"

namespace trembler::render::shaders {

std::string_view const shapeVertex = R"(#version 330 core
layout(location = 0) in vec2 a_centre;
layout(location = 1) in vec2 a_axis;
layout(location = 2) in vec2 a_half;
layout(location = 3) in vec2 a_radiusOutline;
layout(location = 4) in vec4 a_params;
layout(location = 5) in vec4 a_colour;
layout(location = 6) in vec4 a_edge;
layout(location = 7) in uvec4 a_bits;
layout(location = 8) in float a_grain;

uniform vec2 u_viewHalf; // metres from the middle of the view to its right and upper edge
uniform float u_pixel;   // metres per pixel
uniform float u_ui;      // UI scale
uniform vec2 u_flatAt;   // metres from the middle of the view: the place about which shapes are flattened
uniform vec2 u_flatBy;   // factors to the right and up

out vec2 v_local; // metres, in the shape's frame
out vec2 v_view;  // metres, from the camera's centre
flat out vec2 f_axis;
flat out vec2 f_half;
flat out float f_radius;
flat out float f_outline;
flat out vec4 f_params;
flat out vec4 f_colour;
flat out vec4 f_edge;
flat out uvec4 f_bits;
flat out float f_grain;

void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
    float margin = u_pixel;
    if (a_bits.y == 1u || a_bits.y == 2u) {
        margin += a_radiusOutline.y;
    }
    if ((a_bits.w & 1u) != 0u) {
        margin += 9.0 * u_ui * u_pixel;
    }
    v_local = corner * (a_half + margin);
    v_view = a_centre + vec2(a_axis.x * v_local.x - a_axis.y * v_local.y,
                             a_axis.y * v_local.x + a_axis.x * v_local.y);
    vec2 seen = (a_bits.w & 64u) != 0u ? u_flatAt + u_flatBy * (v_view - u_flatAt) : v_view;
    gl_Position = vec4(seen / u_viewHalf, 0.0, 1.0);
    f_axis = a_axis;
    f_half = a_half;
    f_radius = a_radiusOutline.x;
    f_outline = a_radiusOutline.y;
    f_params = a_params;
    f_colour = a_colour;
    f_edge = a_edge;
    f_bits = a_bits;
    f_grain = a_grain;
}
)";

} // namespace trembler::render::shaders
