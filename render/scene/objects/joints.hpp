// The joints that tie bodies together: pins, rods, ropes, springs, pulleys, rails and gears.
#pragma once

#include "physics/dynamics/properties/joint.hpp"
#include "render/draw/canvas.hpp"
#include "render/scene/objects/wires.hpp"

#include <optional>
#include <span>

namespace trembler::render {

/// Where a joint holds its two objects at present, in the world.
struct JointPlaces {
    Point a;
    Point b;
    double angleA = 0;    ///< rad, of object a
    double angleB = 0;    ///< rad, of object b; 0 for the world
    Point axis{1, 0};     ///< unit, as it lies now (slider, wheel)
    double length = 0;    ///< m, of a rope at full stretch, of a spring at rest; 0: not known
    bool toWorld = false; ///< there is no object b
};

/// Nothing if the joint, or an object that it ties, does not exist or has no place.
[[nodiscard]] std::optional<JointPlaces> placesOf(World const& world, FactsReader const& reader,
                                                  ObjectId joint, PoseOf const& poseOf);

/// Where the joint is stated to hold them, which is right until the first frame.
[[nodiscard]] JointPlaces statedPlaces(Joint const& joint);

/// A rope of a length between two points: straight if taut, else sagging as a parabola of that length.
[[nodiscard]] std::vector<Point> ropePath(Point from, Point to, double length);

/// A gear joint of two wheels about their pins: a belt or a chain around both, or their pitch circles.
void drawGear(Canvas& canvas, Joint const& joint, Facts const& wheelA, Facts const& wheelB,
              JointPlaces const& pinA, JointPlaces const& pinB);

/// Draws all joints of the world but the hidden ones.
void drawJoints(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf,
                std::span<ObjectId const> hidden = {});

} // namespace trembler::render
