// The displaced area by brute force: a few thousand strips across both shapes. Shares only the description of
// shapes with the code under test.
#pragma once

#include "physics/dynamics/properties/shape.hpp"

#include <optional>
#include <vector>

namespace trembler::test {

/// One convex piece in the world, as cut by horizontal lines.
class Slab {
public:
    /// `piece` of a shape whose frame is at `at`, turned by `angle` (rad).
    Slab(ShapePiece const& piece, Vec2 at, double angle);
    struct Interval {
        double from = 0;
        double to = 0;
    };
    /// The intersection of the piece with the line at height y.
    [[nodiscard]] std::optional<Interval> at(double y) const;
    [[nodiscard]] Interval heights() const { return heights_; }

private:
    struct Round {
        Vec2 centre;
        double radius;
    };
    std::vector<Vec2> corners_; // of a convex polygon, or none
    std::vector<Round>
        discs_; // the piece is the hull of all; each line cuts the hull in the hull of its cuts
    Interval heights_;
};

struct Strips {
    double area = 0;
    Vec2 centroid;
    double xx = 0; ///< second moments about the world's origin
    double xy = 0;
    double yy = 0;
};

/// The intersection of two pieces, by the midpoint rule over `count` strips.
[[nodiscard]] Strips common(Slab const& a, Slab const& b, int count = 4000);

} // namespace trembler::test
