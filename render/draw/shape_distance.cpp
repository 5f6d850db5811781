// Signed distances (metres, negative inside) of every kind of shape, for the fragment shader.
#include "render/draw/shaders.hpp"

namespace trembler::render::shaders {

std::string_view const shapeCommon = R"(
in vec2 v_local;
in vec2 v_view;
flat in vec2 f_axis;
flat in vec2 f_half;
flat in float f_radius;
flat in float f_outline;
flat in vec4 f_params;
flat in vec4 f_colour;
flat in vec4 f_edge;
flat in uvec4 f_bits; // kind, effect, pattern, flags
flat in float f_grain;

uniform samplerBuffer u_corners;
uniform float u_pixel;
uniform float u_ui;
uniform float u_time;
uniform vec3 u_accent;
uniform vec3 u_warning;

out vec4 o_colour; // premultiplied

vec2 toLocal(vec2 v) { return vec2(f_axis.x * v.x + f_axis.y * v.y, f_axis.x * v.y - f_axis.y * v.x); }
vec2 toView(vec2 v) { return vec2(f_axis.x * v.x - f_axis.y * v.y, f_axis.x * v.y + f_axis.y * v.x); }

// How much of this pixel lies inside an edge at distance d.
float coverage(float d) { return clamp(0.5 - d / u_pixel, 0.0, 1.0); }
)";

std::string_view const shapeDistance = R"(
float boxDistance(vec2 p) {
    vec2 beyond = abs(p) - f_half + f_radius;
    return length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - f_radius;
}

// Distance to the nearest edge; inside by counting how often a ray to the right crosses edges, so that shapes need
// not be convex.
float polygonDistance(vec2 p) {
    int first = int(f_params.x);
    int count = int(f_params.y);
    float nearest = 1e30;
    bool inside = false;
    vec2 a = texelFetch(u_corners, first + count - 1).xy;
    for (int i = 0; i < count; ++i) {
        vec2 b = texelFetch(u_corners, first + i).xy;
        vec2 edge = b - a;
        vec2 gap = p - a;
        float crossing = a.x + (p.y - a.y) * edge.x / edge.y; // only used where edge.y is not 0
        if ((a.y > p.y) != (b.y > p.y) && p.x < crossing) {
            inside = !inside;
        }
        gap -= edge * clamp(dot(gap, edge) / max(dot(edge, edge), 1e-20), 0.0, 1.0);
        nearest = min(nearest, dot(gap, gap));
        a = b;
    }
    return (inside ? -sqrt(nearest) : sqrt(nearest)) - f_radius;
}

float arcDistance(vec2 p) {
    // The arc's middle lies on the x axis; folded there, one end is enough.
    vec2 q = vec2(p.x, abs(p.y));
    float away = length(q);
    // Compared as cosines: no angle need be computed.
    bool within = q.x >= f_params.z * away;
    return (within ? abs(away - f_params.x) : length(q - f_params.x * f_params.zw)) - f_params.y;
}

// Distance to a path near one of its segments; far outside if another segment is nearer, because then that one draws
// this pixel. So a see-through line, or a glow, is nowhere drawn twice.
float chainDistance(vec2 p) {
    int first = int(f_params.x);
    int last = int(f_params.y);
    int own = int(f_params.z);
    float nearest = 1e30;
    int which = own;
    vec2 a = texelFetch(u_corners, first).xy;
    for (int i = first; i < last; ++i) {
        vec2 b = texelFetch(u_corners, i + 1).xy;
        vec2 edge = b - a;
        vec2 gap = p - a;
        gap -= edge * clamp(dot(gap, edge) / max(dot(edge, edge), 1e-20), 0.0, 1.0);
        float d = dot(gap, gap);
        // At a joint both neighbours are equally near but for rounding: then the first of them has it.
        if (d < nearest * 0.9999) {
            nearest = d;
            which = i;
        }
        a = b;
    }
    return which == own ? sqrt(nearest) - f_radius : 1e15;
}

// p in the shape's own frame.
float distanceTo(vec2 p) {
#if KIND == 0
    return boxDistance(p);
#elif KIND == 1
    return polygonDistance(p);
#elif KIND == 2
    return arcDistance(p);
#else
    return chainDistance(v_view + toView(p - v_local));
#endif
}
)";

} // namespace trembler::render::shaders
