// The patterns of surfaces (enum Pattern). They are computed, not stored, so they are crisp at any zoom;
// where a pattern would be finer than a pixel it fades into its mean.
#include "render/draw/shaders.hpp"

namespace trembler::render::shaders {

std::string_view const shapePattern = R"(
uint scramble(uint x) {
    x ^= x >> 16; x *= 0x7feb352du;
    x ^= x >> 15; x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

// 0..1, the same for the same cell on every driver.
float cellValue(ivec2 cell) {
    return float(scramble(uint(cell.x) + scramble(uint(cell.y) * 0x9e3779b9u)) >> 8) / 16777216.0;
}

// Smooth noise, 0..1, features about 1 wide.
float noise(vec2 p) {
    vec2 cell = floor(p);
    vec2 t = p - cell;
    t = t * t * (3.0 - 2.0 * t);
    ivec2 c = ivec2(cell);
    return mix(mix(cellValue(c), cellValue(c + ivec2(1, 0)), t.x),
               mix(cellValue(c + ivec2(0, 1)), cellValue(c + ivec2(1, 1)), t.x), t.y);
}

// 1 where a pattern with this many features per metre can be seen, 0 where it is finer than pixels.
float visible(float featuresPerMetre) { return 1.0 - smoothstep(0.25, 0.6, featuresPerMetre * u_pixel); }

// A soft-edged band around `at`.
float band(float x, float at, float halfWidth) { return 1.0 - smoothstep(halfWidth * 0.75, halfWidth, abs(x - at)); }

// Where this pixel lies across the shape as the light sees it, about -1..1; it stays when the shape turns.
float across() { return dot(toView(v_local), vec2(0.80, -0.60)) / max(length(f_half), 1e-9) * 1.25; }

// Long fine streaks along the part and one broad sheen without an edge; hard reflections are glass's alone.
vec3 brushed(vec3 base, vec2 p, float shine) {
    float fine = 18.0;
    float streaks = noise(vec2(p.x * 0.9, p.y * fine)) + 0.7 * noise(vec2(p.x * 2.1 + 9.0, p.y * fine * 2.3));
    vec3 c = base * (1.0 + (streaks - 0.85) * 0.30 * visible(fine / f_grain));
    float s = across();
    float sheen = exp(-pow((s + 0.22) / 0.26, 2.0));
    c = mix(c, vec3(1.0, 0.99, 0.97), shine * 0.62 * sheen);
    return mix(c, base * 0.62, 0.60 * smoothstep(0.10, 1.0, s));
}

vec3 grained(vec3 base, vec2 p) {
    float rings = p.y * 2.4 + 0.9 * noise(vec2(p.x * 0.30, p.y * 0.7)) + 0.25 * noise(vec2(p.x * 1.3 + 4.0, p.y * 2.0));
    float growth = fract(rings);
    // A year's wood darkens slowly and starts light again at once.
    float late = growth * growth * (1.0 - smoothstep(0.92, 1.0, growth));
    vec3 c = base * mix(1.0, 1.10 - 0.42 * late, visible(3.2 / f_grain));
    float fibre = noise(vec2(p.x * 3.0, p.y * 30.0));
    return c * (1.0 + (fibre - 0.5) * 0.13 * visible(30.0 / f_grain));
}

vec3 speckled(vec3 base, vec2 p) {
    float clouds = noise(p * 2.1) - 0.5;
    vec3 c = base * (1.0 + 0.16 * clouds);
    float count = 4.5;
    ivec2 cell = ivec2(floor(p * count));
    float pick = cellValue(cell);
    vec2 middle = vec2(cellValue(cell + ivec2(31, 7)), cellValue(cell + ivec2(5, 77))) * 0.5 + 0.25;
    float size = 0.12 + 0.20 * cellValue(cell + ivec2(101, 13));
    float grain = coverage((length(fract(p * count) - middle) - size) * f_grain / count);
    float shown = grain * visible(count / f_grain);
    c = mix(c, base * 0.55, shown * step(pick, 0.38));
    return mix(c, mix(base, vec3(1.0), 0.55), shown * step(0.72, pick));
}

vec3 stippled(vec3 base, vec2 p) {
    float count = 4.5;
    vec2 q = p * count;
    q.x += 0.5 * mod(floor(q.y), 2.0);
    float dots = coverage((length(fract(q) - 0.5) - 0.20) * f_grain / count);
    vec3 c = mix(base, base * 0.62, dots * visible(count / f_grain));
    return mix(c, vec3(0.62, 0.62, 0.66), 0.16 * (1.0 - smoothstep(-0.9, 0.3, across())));
}

vec4 seeThrough(vec4 base, float d) {
    float s = across();
    vec4 c = base;
    // Thicker, and so more tinted, towards the edge.
    float thick = smoothstep(-0.35 * f_grain, 0.0, d);
    c.a = mix(c.a, min(c.a + 0.25, 1.0), thick);
    float light = 0.70 * band(s, -0.34, 0.13) + 0.45 * band(s, -0.08, 0.05);
    return mix(c, vec4(1.0, 1.0, 1.0, 0.85), light);
}

vec4 watery(vec4 base, vec2 view, float d) {
    vec2 p = view / f_grain;
    float swell = sin(p.x * 2.4 + u_time * 1.3 + 1.2 * sin(p.y * 1.3 - u_time * 0.5));
    float line = fract(p.y * 1.6 + 0.16 * swell + 0.05 * u_time);
    vec4 c = base;
    c.rgb = mix(c.rgb, vec3(1.0), 0.38 * band(line, 0.5, 0.07) * smoothstep(0.1, 0.9, noise(p * vec2(1.1, 2.0))) *
                                      visible(3.0 / f_grain));
    c.rgb = mix(c.rgb, c.rgb * 0.78, smoothstep(0.0, -1.5 * f_grain, d) * 0.5);
    return c;
}

// The body's colour at p (shape's frame), not premultiplied; d is the distance to the edge.
vec4 patternColour(vec4 base, vec2 p, float d) {
    // Parts of different size get different pieces of the pattern.
    vec2 q = p / f_grain + f_half.yx * 3.7;
#if PATTERN == 1
    return vec4(brushed(base.rgb, q, 0.75), base.a);
#elif PATTERN == 2
    return vec4(grained(base.rgb, q), base.a);
#elif PATTERN == 3
    return seeThrough(base, d);
#elif PATTERN == 4
    return vec4(stippled(base.rgb, q), base.a);
#elif PATTERN == 5
    return vec4(speckled(base.rgb, q), base.a);
#elif PATTERN == 7
    return vec4(brushed(base.rgb, q, 0.95), base.a);
#elif PATTERN == 8
    return watery(base, toView(p), d);
#else
    return base;
#endif
}
)";

} // namespace trembler::render::shaders
