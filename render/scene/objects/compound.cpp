#include "render/scene/objects/compound.hpp"

#include <algorithm>

namespace trembler::render {
namespace {

constexpr double nudge = 1e-4; // m, to look beside an edge; pieces are at least a centimetre large

// Least distance to any piece but one.
double distanceToOthers(Shape const& shape, std::size_t own, Point at) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < shape.pieces.size(); ++i) {
        if (i != own) {
            least = std::min(least, distanceTo(shape.pieces[i], at));
        }
    }
    return least;
}

// Where along a side (0 to 1) it enters or leaves any other piece; with both ends, ascending.
std::vector<double> breaks(std::vector<std::vector<Point>> const& outlines, std::size_t own, Point from,
                           Point side) {
    std::vector<double> cuts{0, 1};
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        auto const inside = i == own ? std::nullopt : clipLine(outlines[i], from, side);
        if (!inside) {
            continue;
        }
        for (Point const end : *inside) {
            double const t = dot(end - from, side) / dot(side, side);
            if (t > 0 && t < 1) {
                cuts.push_back(t);
            }
        }
    }
    // A side that runs along another piece's side is cut by that one's neighbours only, if rounding so
    // decides.
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        for (Point const corner : i == own ? std::vector<Point>{} : outlines[i]) {
            double const t = dot(corner - from, side) / dot(side, side);
            if (t > 0 && t < 1 && length(from + t * side - corner) < nudge) {
                cuts.push_back(t);
            }
        }
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

// The rest of a convex part when a convex hole is cut out: at most one part for each side of the hole.
std::vector<std::vector<Point>> cutOut(std::vector<Point> part, std::span<Point const> hole) {
    std::vector<std::vector<Point>> left;
    for (std::size_t i = 0; i < hole.size() && part.size() >= 3; ++i) {
        Point const side = hole[(i + 1) % hole.size()] - hole[i];
        Point const inwards{-side.y, side.x};
        auto outside = clipHalf(part, hole[i], -1.0 * inwards);
        if (outside.size() >= 3) {
            left.push_back(std::move(outside));
        }
        part = clipHalf(part, hole[i], inwards);
    }
    return left;
}

double areaOf(std::span<Point const> corners) {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Point const a = corners[i];
        Point const b = corners[(i + 1) % corners.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

} // namespace

CompoundEdges edgesOf(Shape const& shape, double depth) {
    CompoundEdges edges;
    std::vector<std::vector<Point>> outlines;
    for (ShapePiece const& piece : shape.pieces) {
        outlines.push_back(outlineOf(piece));
    }
    for (std::size_t own = 0; own < outlines.size(); ++own) {
        for (std::size_t i = 0; i < outlines[own].size(); ++i) {
            Point const from = outlines[own][i];
            Point const side = outlines[own][(i + 1) % outlines[own].size()] - from;
            double const span = length(side);
            if (!(span > 0)) {
                continue;
            }
            Point const outwards{side.y / span, -side.x / span};
            std::vector<double> const cuts = breaks(outlines, own, from, side);
            for (std::size_t c = 1; c < cuts.size(); ++c) {
                Segment const part{from + cuts[c - 1] * side, from + cuts[c] * side};
                if (!(cuts[c] - cuts[c - 1] > 1e-9)) {
                    continue;
                }
                Point const middle = 0.5 * (part[0] + part[1]);
                if (distanceToOthers(shape, own, middle + nudge * outwards) > 0) {
                    edges.outer.push_back(part);
                } else if (distanceToOthers(shape, own, middle) > -depth) {
                    edges.seams.push_back(part);
                }
            }
        }
    }
    return edges;
}

std::vector<std::vector<Point>> withoutOverlaps(Shape const& shape) {
    std::vector<std::vector<Point>> outlines;
    for (ShapePiece const& piece : shape.pieces) {
        outlines.push_back(outlineOf(piece));
    }
    std::stable_sort(outlines.begin(), outlines.end(),
                     [](auto const& a, auto const& b) { return a.size() < b.size(); });
    std::vector<std::vector<Point>> all;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        std::vector<std::vector<Point>> parts{outlines[i]};
        for (std::size_t j = 0; j < i; ++j) {
            std::vector<std::vector<Point>> next;
            for (std::vector<Point>& part : parts) {
                for (std::vector<Point>& left : cutOut(std::move(part), outlines[j])) {
                    next.push_back(std::move(left));
                }
            }
            parts = std::move(next);
        }
        for (std::vector<Point>& part : parts) {
            if (areaOf(part) > 1e-9) {
                all.push_back(std::move(part));
            }
        }
    }
    return all;
}

ShapePiece const& largestPiece(Shape const& shape) {
    return *std::max_element(
        shape.pieces.begin(), shape.pieces.end(),
        [](ShapePiece const& a, ShapePiece const& b) { return trembler::areaOf(a) < trembler::areaOf(b); });
}

} // namespace trembler::render
