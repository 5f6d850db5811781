// The sheet that everything lies on: warm paper with a squared ruling that subdivides as one zooms in.
#include "render/draw/shaders.hpp"

namespace trembler::render::shaders {

std::string_view const paperVertex = R"(#version 330 core
void main() {
    // One triangle that covers the view: no seam along a diagonal.
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

std::string_view const paperFragment = R"(#version 330 core
uniform vec3 u_paper;
uniform vec3 u_grid;
uniform vec2 u_size;    // pixels
uniform vec2 u_origin;  // a crossing of the coarsest ruling, pixels from the lower left
uniform vec2 u_rulings[5]; // pixels between lines, strength 0..1
uniform float u_thick;  // pixels, whole
out vec4 o_colour;

uint scramble(uint x) {
    x ^= x >> 16; x *= 0x7feb352du;
    x ^= x >> 15; x *= 0x846ca68bu;
    return x ^ (x >> 16);
}
float speck(ivec2 p) { return float(scramble(uint(p.x) + scramble(uint(p.y))) >> 8) / 16777216.0; }

// 1 on the line nearest to this pixel. Lines are snapped to whole pixels and so are equally sharp everywhere.
float line(float at, float origin, float spacing) {
    float nearest = origin + floor((at - origin) / spacing + 0.5) * spacing;
    float left = floor(nearest - 0.5 * u_thick + 0.5);
    return at > left && at < left + u_thick ? 1.0 : 0.0;
}

float ruling(float spacing) {
    return max(line(gl_FragCoord.x, u_origin.x, spacing), line(gl_FragCoord.y, u_origin.y, spacing));
}

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    // Fibres: short threads, lighter and darker than the sheet by about one hundredth.
    float fibre = speck(p / ivec2(5, 1)) + speck(p / ivec2(1, 4) + 977) + speck(p) - 1.5;
    vec3 c = u_paper * (1.0 + 0.010 * fibre);
    float lines = 0.0;
    for (int i = 0; i < 5; ++i) {
        lines = max(lines, u_rulings[i].y * ruling(u_rulings[i].x));
    }
    c = mix(c, u_grid, lines);
    vec2 off = gl_FragCoord.xy / u_size - 0.5;
    c *= 1.0 - 0.16 * smoothstep(0.15, 0.60, dot(off, off));
    o_colour = vec4(c, 1.0);
}
)";

} // namespace trembler::render::shaders
