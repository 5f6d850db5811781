#include "game/ui/edit/tools/drawn_shape.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::ui {
namespace {

constexpr double smallestSide = 0.01;   // m, as the description of shapes states
constexpr double smallestRadius = 0.005; // m
constexpr std::size_t mostCorners = 8;
constexpr double smallestArea = 1e-5; // m²

/// Twice the area of the triangle, positive if it turns anticlockwise.
double turnOf(Vec2 a, Vec2 b, Vec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double signedArea(std::span<Vec2 const> corners) {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Vec2 const a = corners[i];
        Vec2 const b = corners[(i + 1) % corners.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

bool sidesCross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    return turnOf(a, b, c) * turnOf(a, b, d) < 0 && turnOf(c, d, a) * turnOf(c, d, b) < 0;
}

bool inTriangle(Vec2 p, Vec2 a, Vec2 b, Vec2 c) {
    return turnOf(a, b, p) >= 0 && turnOf(b, c, p) >= 0 && turnOf(c, a, p) >= 0;
}

bool isConvex(std::vector<Vec2> const& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        std::size_t const n = corners.size();
        if (turnOf(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) <= 1e-9) {
            return false;
        }
    }
    return true;
}

/// Cuts off ears; the corners are anticlockwise.
std::vector<std::vector<Vec2>> triangles(std::vector<Vec2> rest) {
    std::vector<std::vector<Vec2>> all;
    while (rest.size() > 3) {
        std::size_t const n = rest.size();
        bool cut = false;
        for (std::size_t i = 0; i < n && !cut; ++i) {
            Vec2 const a = rest[(i + n - 1) % n];
            Vec2 const b = rest[i];
            Vec2 const c = rest[(i + 1) % n];
            double const turn = turnOf(a, b, c);
            if (turn < -1e-12) {
                continue;
            }
            bool const free = std::none_of(rest.begin(), rest.end(), [&](Vec2 p) {
                return p != a && p != b && p != c && inTriangle(p, a, b, c);
            });
            if (free) {
                if (turn > 1e-9) { // else the three lie in a line: nothing is cut off
                    all.push_back({a, b, c});
                }
                rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
                cut = true;
            }
        }
        if (!cut) {
            return {};
        }
    }
    if (turnOf(rest[0], rest[1], rest[2]) > 1e-9) {
        all.push_back(rest);
    }
    return all;
}

/// Both pieces as one along a side that they share, if that is convex and has few enough corners.
std::optional<std::vector<Vec2>> joined(std::vector<Vec2> const& a, std::vector<Vec2> const& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (a[i] != b[(j + 1) % b.size()] || a[(i + 1) % a.size()] != b[j]) {
                continue;
            }
            std::vector<Vec2> both;
            for (std::size_t k = 0; k < a.size(); ++k) { // from the end of the shared side round to its start
                both.push_back(a[(i + 1 + k) % a.size()]);
            }
            for (std::size_t k = 2; k < b.size(); ++k) {
                both.push_back(b[(j + k) % b.size()]);
            }
            return both.size() <= mostCorners && isConvex(both) ? std::optional(both) : std::nullopt;
        }
    }
    return {};
}

void joinPieces(std::vector<std::vector<Vec2>>& pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t j = i + 1; j < pieces.size();) {
            if (auto both = joined(pieces[i], pieces[j])) {
                pieces[i] = std::move(*both);
                pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(j));
                j = i + 1;
            } else {
                ++j;
            }
        }
    }
}

} // namespace

std::optional<DrawnShape> drawnBox(Vec2 from, Vec2 to) {
    double const width = std::abs(to.x - from.x);
    double const height = std::abs(to.y - from.y);
    if (width < smallestSide || height < smallestSide) {
        return {};
    }
    return DrawnShape{0.5 * (from + to), 0, Shape{{boxPiece(width, height)}}};
}

std::optional<DrawnShape> drawnDisc(Vec2 centre, Vec2 edge) {
    double const radius = length(edge - centre);
    if (radius < smallestRadius) {
        return {};
    }
    return DrawnShape{centre, 0, Shape{{circlePiece(radius)}}};
}

std::optional<DrawnShape> drawnCapsule(Vec2 from, Vec2 to, double radius) {
    Vec2 const along = to - from;
    double const distance = length(along);
    if (distance < smallestSide || radius < smallestRadius) {
        return {};
    }
    return DrawnShape{0.5 * (from + to), std::atan2(along.y, along.x),
                      Shape{{capsulePiece(distance + 2 * radius, radius)}}};
}

bool crossesItself(std::span<Vec2 const> corners) {
    std::size_t const n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            if (corners[i] == corners[j] ||
                sidesCross(corners[i], corners[(i + 1) % n], corners[j], corners[(j + 1) % n])) {
                return true;
            }
        }
    }
    return false;
}

std::optional<DrawnShape> drawnPolygon(std::span<Vec2 const> corners) {
    if (corners.size() < 3 || crossesItself(corners) || std::abs(signedArea(corners)) < smallestArea) {
        return {};
    }
    Vec2 low = corners.front();
    Vec2 high = low;
    for (Vec2 const corner : corners) {
        low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
        high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    DrawnShape drawn{0.5 * (low + high), 0, {}};
    std::vector<Vec2> own;
    for (Vec2 const corner : corners) {
        own.push_back(corner - drawn.at);
    }
    if (signedArea(own) < 0) {
        std::reverse(own.begin(), own.end());
    }
    std::vector<std::vector<Vec2>> pieces;
    if (own.size() <= mostCorners && isConvex(own)) {
        pieces.push_back(own);
    } else {
        pieces = triangles(own);
        joinPieces(pieces);
    }
    if (pieces.empty()) {
        return {};
    }
    for (std::vector<Vec2>& piece : pieces) {
        drawn.shape.pieces.push_back(polygonPiece(std::move(piece)));
    }
    return drawn;
}

} // namespace trembler::ui
