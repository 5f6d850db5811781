// Detail level "particles": the thesis's model (6.11), a body as a number of small discs.
#pragma once

#include "physics/buoyancy/hulls/hull.hpp"

namespace trembler {

/// Every particle is cut by the one side of the liquid that it extends beyond most; its part inside is a
/// circular segment. The body's immersed area and centroid are sums over these parts (6.11). The particles'
/// areas add up to the body's, and their mean is its centroid.
class ParticleHull final : public Hull {
public:
    struct Particle {
        Vec2 at;           ///< m, in the body's frame
        double radius = 0; ///< m
    };

    /// About `count` particles, 4 or more. The shape must be valid (see faultIn()).
    ///
    /// They are divided among the pieces by area, at least four for each, and spread over each by the R2
    /// sequence (Roberts 2018), which is deterministic and evenly spread for any number of points. In a box,
    /// circle or capsule a quarter of them is spread over a quarter of it and mirrored, so that a symmetric
    /// body floats upright.
    ParticleHull(Shape const& shape, int count);
    [[nodiscard]] Displacement displaced(std::span<Side const> sides, Vec2 up) const override;

    [[nodiscard]] std::span<Particle const> particles() const { return particles_; }

private:
    std::vector<Particle> particles_;
};

} // namespace trembler
