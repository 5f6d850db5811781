#include "puzzle/edit/tree/convex_pieces.hpp"

#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "puzzle/edit/document/command.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::edit {
namespace {

using Polygon = std::vector<Vec2>;

constexpr std::size_t mostCorners = 200;
constexpr double leastSine = 2e-3; // of the turn at a corner: flatter ones are on a line

double turnAt(Vec2 before, Vec2 here, Vec2 after) {
    return cross(here - before, after - here);
}

bool onLine(Vec2 before, Vec2 here, Vec2 after) {
    double const scale = length(here - before) * length(after - here);
    return std::abs(turnAt(before, here, after)) <= leastSine * scale;
}

double twiceArea(Polygon const& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        sum += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    }
    return sum;
}

Vec2 centreOf(Polygon const& polygon) {
    Vec2 sum;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        Vec2 const a = polygon[i] - polygon[0];
        Vec2 const b = polygon[i + 1] - polygon[0];
        sum = sum + (a + b) * (cross(a, b) / 3);
    }
    return polygon[0] + sum * (1 / twiceArea(polygon));
}

/// Leaves out corners that are too near to the next one, or lie on the line between their neighbours.
Polygon withoutNeedlessCorners(Polygon polygon) {
    for (bool again = true; again && polygon.size() >= 3;) {
        again = false;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            std::size_t const count = polygon.size();
            Vec2 const before = polygon[(i + count - 1) % count];
            Vec2 const after = polygon[(i + 1) % count];
            if (length(after - polygon[i]) < minimumExtent || onLine(before, polygon[i], after)) {
                polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
                again = true;
                break;
            }
        }
    }
    return polygon;
}

/// Whether the lines between a and b, and c and d, have a point in common.
bool meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    auto const side = [](Vec2 from, Vec2 to, Vec2 point) {
        double const turned = cross(to - from, point - from);
        return turned > 0 ? 1 : (turned < 0 ? -1 : 0);
    };
    auto const within = [](Vec2 from, Vec2 to, Vec2 point) {
        return std::min(from.x, to.x) <= point.x && point.x <= std::max(from.x, to.x) &&
               std::min(from.y, to.y) <= point.y && point.y <= std::max(from.y, to.y);
    };
    int const c1 = side(a, b, c);
    int const d1 = side(a, b, d);
    int const a1 = side(c, d, a);
    int const b1 = side(c, d, b);
    return (c1 * d1 < 0 && a1 * b1 < 0) || (c1 == 0 && within(a, b, c)) || (d1 == 0 && within(a, b, d)) ||
           (a1 == 0 && within(c, d, a)) || (b1 == 0 && within(c, d, b));
}

bool crossesItself(Polygon const& polygon) {
    std::size_t const count = polygon.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 2; j < count; ++j) {
            bool const neighbours = i == 0 && j + 1 == count;
            if (!neighbours && meet(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % count])) {
                return true;
            }
        }
    }
    return false;
}

bool isInside(Vec2 a, Vec2 b, Vec2 c, Vec2 point) {
    return cross(b - a, point - a) >= 0 && cross(c - b, point - b) >= 0 && cross(a - c, point - c) >= 0;
}

/// The triangles of a simple anticlockwise polygon.
std::vector<Polygon> trianglesOf(Polygon polygon) {
    std::vector<Polygon> triangles;
    while (polygon.size() > 3) {
        std::size_t const count = polygon.size();
        std::size_t best = count;
        double bestSine = 0; // the fattest ear: thin pieces are bad for the physics
        for (std::size_t i = 0; i < count; ++i) {
            Vec2 const a = polygon[(i + count - 1) % count];
            Vec2 const b = polygon[i];
            Vec2 const c = polygon[(i + 1) % count];
            double const sine = turnAt(a, b, c) / std::max(1e-300, length(b - a) * length(c - b));
            bool const isEar = sine > 0 && std::none_of(polygon.begin(), polygon.end(), [&](Vec2 other) {
                                   return other != a && other != b && other != c && isInside(a, b, c, other);
                               });
            if (isEar && sine > bestSine) {
                best = i;
                bestSine = sine;
            }
        }
        if (best == count) {
            throw CommandError("this polygon cannot be divided into convex pieces; draw a simpler one");
        }
        triangles.push_back(
            {polygon[(best + count - 1) % count], polygon[best], polygon[(best + 1) % count]});
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(best));
    }
    triangles.push_back(std::move(polygon));
    return triangles;
}

bool isConvex(Polygon const& polygon) {
    std::size_t const count = polygon.size();
    for (std::size_t i = 0; i < count; ++i) {
        Vec2 const before = polygon[(i + count - 1) % count];
        Vec2 const after = polygon[(i + 1) % count];
        if (turnAt(before, polygon[i], after) <= 0 || onLine(before, polygon[i], after)) {
            return false;
        }
    }
    return true;
}

/// Two polygons as one, if they share an edge and the result is convex and has few enough corners.
bool joinInto(Polygon& one, Polygon const& other) {
    if (one.size() + other.size() - 2 > maximumCorners) {
        return false;
    }
    for (std::size_t i = 0; i < one.size(); ++i) {
        Vec2 const from = one[i];
        Vec2 const to = one[(i + 1) % one.size()];
        for (std::size_t j = 0; j < other.size(); ++j) {
            if (other[j] != to || other[(j + 1) % other.size()] != from) {
                continue;
            }
            Polygon joined;
            for (std::size_t k = 1; k <= one.size(); ++k) { // from `to` round to `from`
                joined.push_back(one[(i + k) % one.size()]);
            }
            for (std::size_t k = 2; k < other.size(); ++k) { // the corners of `other` between them
                joined.push_back(other[(j + k) % other.size()]);
            }
            if (isConvex(joined)) {
                one = std::move(joined);
                return true;
            }
        }
    }
    return false;
}

} // namespace

ConvexPieces convexPieces(std::span<Vec2 const> corners) {
    Polygon polygon(corners.begin(), corners.end());
    if (polygon.size() > mostCorners) {
        throw CommandError("a polygon has at most 200 corners");
    }
    if (std::any_of(polygon.begin(), polygon.end(), [](Vec2 corner) { return !isFinite(corner); })) {
        throw CommandError("a corner is nowhere");
    }
    polygon = withoutNeedlessCorners(std::move(polygon));
    if (polygon.size() < 3) {
        throw CommandError("a polygon needs three corners that do not lie on one line");
    }
    if (crossesItself(polygon)) {
        throw CommandError("the edges of a polygon must not cross");
    }
    if (twiceArea(polygon) < 0) {
        std::reverse(polygon.begin(), polygon.end());
    }
    ConvexPieces made{centreOf(polygon), {}};
    for (Polygon const& triangle : trianglesOf(polygon)) {
        bool const joined = std::any_of(made.pieces.begin(), made.pieces.end(),
                                        [&](Polygon& piece) { return joinInto(piece, triangle); });
        if (!joined) {
            made.pieces.push_back(triangle);
        }
    }
    for (bool again = true; again;) { // pieces that grew may fit together now
        again = false;
        for (std::size_t i = 0; i < made.pieces.size() && !again; ++i) {
            for (std::size_t j = i + 1; j < made.pieces.size() && !again; ++j) {
                if (joinInto(made.pieces[i], made.pieces[j])) {
                    made.pieces.erase(made.pieces.begin() + static_cast<std::ptrdiff_t>(j));
                    again = true;
                }
            }
        }
    }
    return made;
}

} // namespace trembler::edit
