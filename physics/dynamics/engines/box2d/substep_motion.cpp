#include "physics/dynamics/engines/box2d/substep_motion.hpp"

#include <algorithm>

namespace trembler {
namespace {

// Tests the gap along the line through the centroids: the fastest test, sufficient for most pairs of compact
// shapes.
bool apartAlongCentroids(b2PolygonShape const& a, b2Transform const& atA, b2PolygonShape const& b,
                         b2Transform const& atB, float skin) {
    b2Vec2 const axis = b2Mul(atB, b.m_centroid) - b2Mul(atA, a.m_centroid);
    b2Vec2 const axisInA = b2MulT(atA.q, axis);
    b2Vec2 const axisInB = b2MulT(atB.q, axis);
    float end = b2Dot(axisInA, a.m_vertices[0]);
    for (int i = 1; i < a.m_count; ++i) {
        end = std::max(end, b2Dot(axisInA, a.m_vertices[i]));
    }
    float begin = b2Dot(axisInB, b.m_vertices[0]);
    for (int i = 1; i < b.m_count; ++i) {
        begin = std::min(begin, b2Dot(axisInB, b.m_vertices[i]));
    }
    float const gap = begin - end + b2Dot(axis, atB.p - atA.p);
    return gap > 0 && gap * gap > skin * skin * axis.LengthSquared();
}

// The largest gap between a face of one polygon and the other one; negative if that reaches behind all faces.
float gapBeforeFaces(b2PolygonShape const& faces, b2Transform const& atFaces, b2PolygonShape const& other,
                     b2Transform const& atOther) {
    b2Transform const otherInFaces = b2MulT(atFaces, atOther);
    float largest = -b2_maxFloat;
    for (int face = 0; face < faces.m_count; ++face) {
        b2Vec2 const normal = b2MulT(otherInFaces.q, faces.m_normals[face]);
        float nearest = b2_maxFloat;
        for (int i = 0; i < other.m_count; ++i) {
            nearest = std::min(nearest, b2Dot(normal, other.m_vertices[i]));
        }
        largest = std::max(largest,
                           nearest + b2Dot(faces.m_normals[face], otherInFaces.p - faces.m_vertices[face]));
    }
    return largest;
}

} // namespace

Overlap overlapOf(b2Shape const& a, b2Transform const& atA, b2Shape const& b, b2Transform const& atB) {
    if (a.GetType() != b2Shape::e_polygon || b.GetType() != b2Shape::e_polygon) {
        return Overlap::unknown;
    }
    auto const& first = static_cast<b2PolygonShape const&>(a);
    auto const& second = static_cast<b2PolygonShape const&>(b);
    float const skin = skinFactor * (first.m_radius + second.m_radius);
    if (apartAlongCentroids(first, atA, second, atB, skin)) {
        return Overlap::none;
    }
    float const beforeFirst = gapBeforeFaces(first, atA, second, atB);
    if (beforeFirst > skin) {
        return Overlap::none;
    }
    float const beforeSecond = gapBeforeFaces(second, atB, first, atA);
    if (beforeSecond > skin) {
        return Overlap::none;
    }
    return beforeFirst < 0 && beforeSecond < 0 ? Overlap::certain : Overlap::unknown;
}

} // namespace trembler
