// A body with the bodies that move with it, and the bodies that lie on these.
#pragma once

#include "physics/buoyancy/hulls/liquid_area.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/dynamics/properties/shapes/overlap.hpp"
#include "runtime/world/world.hpp"

#include <span>
#include <vector>

namespace trembler::insight::load {

/// A body with a weight, as it lies in the world.
struct Body {
    ObjectId id;
    Shape const* shape = nullptr;
    Pose pose;
    double angle = 0;
    Vec2 centre; ///< m, of mass, in the world
    Vec2 weight; ///< N
};

/// One object of a pair with the other one.
struct Neighbour {
    ObjectId of;
    ObjectId other; ///< invalid: the world
    bool welded = false;
};

/// The joints and contacts of each object: a scene may have many thousand.
class Neighbours {
public:
    explicit Neighbours(World const& world);
    /// By joints.
    [[nodiscard]] std::span<Neighbour const> tiedTo(ObjectId id) const;
    /// By contacts.
    [[nodiscard]] std::span<Neighbour const> touching(ObjectId id) const;

private:
    std::vector<Neighbour> tied_;
    std::vector<Neighbour> touching_;
};

/// A body and all bodies that joints tie it to, through other bodies as well.
struct Group {
    std::vector<Body> bodies;
    bool welded = true; ///< it moves as one
};

/// The group of an object; without bodies if the object is fixed, a liquid, or has no shape or no weight.
[[nodiscard]] Group groupOf(World const& world, Neighbours const& neighbours, ObjectId id);
/// All bodies that lie on the given ones, directly or on one another, ascending by id. `up`: unit.
[[nodiscard]] std::vector<Body> carriedBy(World const& world, Neighbours const& neighbours,
                                          std::vector<Body> const& bodies, Vec2 up);
/// How far the bodies extend across `up` (unit), m.
[[nodiscard]] double widthOf(std::vector<Body> const& bodies, Vec2 up);

} // namespace trembler::insight::load
