// The area that a body displaces: the part of buoyancy that has detail levels.
#pragma once

#include "physics/buoyancy/hulls/liquid_area.hpp"
#include "physics/buoyancy/properties/moments.hpp"
#include "physics/buoyancy/properties/waterline.hpp"

#include <memory>

namespace trembler {

/// The intersection of a body and a liquid, in the body's frame.
struct Displacement {
    AreaMoments wet;
    Waterline waterline;

    Displacement& operator+=(Displacement const& o) {
        wet += o.wet, waterline += o.waterline;
        return *this;
    }
};

/// A body as a detail level represents it; made once for a shape. Overlapping pieces of a compound count
/// twice, as they do in its mass. Its functions may be called by several threads.
class Hull {
public:
    Hull(AreaMoments const& whole, double radius) : whole_(whole), radius_(radius) {}
    virtual ~Hull() = default;
    Hull(Hull const&) = delete;
    Hull& operator=(Hull const&) = delete;

    /// The part of the body inside of all the sides. `up`: see Waterline::add.
    [[nodiscard]] virtual Displacement displaced(std::span<Side const> sides, Vec2 up) const = 0;

    /// All of the body.
    [[nodiscard]] AreaMoments const& whole() const { return whole_; }
    /// The radius of a circle around the origin that contains the body, in m.
    [[nodiscard]] double radius() const { return radius_; }

protected:
    void setRadius(double radius) { radius_ = radius; }

private:
    AreaMoments whole_;
    double radius_;
};

/// The part of a piece of liquid that a body displaces.
[[nodiscard]] Displacement displacedOf(Hull const& hull, LiquidPiece const& piece, Pose const& pose, Vec2 up);

} // namespace trembler
