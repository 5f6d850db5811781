// From distance and pattern to a pixel: edge, dark outline, two tones, gloss, ghosts, selection, glow and
// shadow.
#include "render/draw/shaders.hpp"

namespace trembler::render::shaders {

std::string_view const shapeFragment = R"(
const vec2 lightFrom = vec2(-0.50, 0.866); // in the view: light comes from the upper left

bool has(uint flag) { return (f_bits.w & flag) != 0u; }

// Two tones: the part that a copy of the shape, moved towards the light, leaves uncovered lies in shade; the
// part that a copy moved away from it leaves uncovered is lit.
vec3 twoTone(vec3 c, float outline) {
    float small = min(f_half.x, f_half.y);
    vec2 light = toLocal(lightFrom);
    float depth = clamp(0.20 * small, 1.0 * u_pixel, 0.12 + 4.0 * u_pixel);
    float shade = 1.0 - coverage(distanceTo(v_local - light * depth) + outline);
    float lit = 1.0 - coverage(distanceTo(v_local + light * depth * 0.45) + outline);
    bool gentle = PATTERN == 3 || PATTERN == 8;
    c = mix(c, c * vec3(0.74, 0.72, 0.74), shade * (gentle ? 0.35 : 1.0));
    float gloss = PATTERN == 4 ? 0.12 : (PATTERN == 2 || PATTERN == 5 ? 0.26 : 0.42);
    return mix(c, vec3(1.0, 0.99, 0.96), lit * gloss * (1.0 - shade));
}

// The glossy strip of plastic: follows the lit edge at a little distance.
vec3 glossy(vec3 c, float d) {
    float small = min(f_half.x, f_half.y);
    float strip = coverage(abs(d + 0.34 * small) - 0.075 * small);
    vec2 light = toLocal(lightFrom);
    float side = dot(normalize(v_local / max(f_half, vec2(1e-9)) + 1e-6), light);
    return mix(c, vec3(1.0), 0.60 * strip * smoothstep(0.55, 0.80, side));
}

// Diagonal stripes that stand still on the screen, 0 or 1 with a soft edge; `period` in pixels.
float stripes(float period) {
    float t = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / (period * u_ui)) - 0.5) * period * u_ui;
    return clamp(t - 0.25 * period * u_ui + 0.5, 0.0, 1.0);
}

vec4 solid(float d) {
    float outline = min(f_outline, 0.45 * min(f_half.x, f_half.y));
#if KIND == 2
    outline = min(f_outline, 0.45 * f_params.y);
#endif
    vec4 edge = f_edge;
    vec4 body = f_colour;
#if SHADED
    body = patternColour(body, v_local, d);
    body.rgb = twoTone(body.rgb, outline);
#if PATTERN == 6
    body.rgb = glossy(body.rgb, d);
#endif
#endif
#if MARKED
    if (has(32u)) {
        body.rgb = mix(body.rgb, vec3(1.0), 0.16);
    }
    if (has(2u)) {
        body.a *= 0.50;
        edge.a *= mix(0.15, 0.95, stripes(11.0));
    }
    if (has(4u)) {
        body = mix(body, vec4(u_warning, max(body.a, 0.75)), 0.25 + 0.60 * stripes(13.0));
        edge = vec4(u_warning * 0.7, 1.0);
    }
#endif
    body.rgb *= body.a;
    edge.rgb *= edge.a;
    if (has(8u)) {
        return edge * coverage(d);
    }
    if (has(16u)) {
        return body * coverage(d + outline);
    }
    float inner = outline > 0.0 ? coverage(d + outline) : 1.0;
    return mix(edge, body, inner) * coverage(d);
}

// A ring in the accent colour with a thin gap of light, and a halo that fades out.
vec4 selection(float d) {
    float px = u_ui * u_pixel;
    float ring = coverage(abs(d - 3.0 * px) - 1.4 * px);
    float gap = coverage(abs(d - 0.9 * px) - 0.9 * px);
    float halo = 0.40 * pow(clamp(1.0 - max(d, 0.0) / (9.0 * px), 0.0, 1.0), 2.0);
    vec4 c = vec4(u_accent, 1.0) * max(ring, halo);
    return mix(c, vec4(1.0), gap * 0.9 * (1.0 - ring));
}

void main() {
    float d = distanceTo(v_local);
#if LIGHT
    // A glow goes by the distance outside only: a falloff that continued inside would show the edge as a dark
    // rim.
    float glow = clamp(1.0 - max(d, 0.0) / f_outline, 0.0, 1.0);
    float shadow = 1.0 - smoothstep(-f_outline, f_outline, d);
    o_colour = vec4(f_colour.rgb, 1.0) * (f_colour.a * (f_bits.y == 1u ? glow * glow : shadow));
#else
#if !MARKED
    if (d > u_pixel) {
        discard; // lets software OpenGL skip the rest for whole blocks of pixels
    }
#endif
    o_colour = solid(d);
#if MARKED
    if (has(1u)) {
        o_colour += selection(d) * (1.0 - o_colour.a);
    }
#endif
#endif
}
)";

} // namespace trembler::render::shaders
