// Electrical connections without a body of their own: cables between objects, lit and in motion where current
// flows.
#pragma once

#include "physics/dynamics/properties/joint.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "render/draw/canvas.hpp"
#include "render/scene/facts/poses.hpp"

#include <functional>
#include <vector>

namespace trembler::render {

/// One connection between two objects.
struct Link {
    ObjectId a; ///< a < b
    ObjectId b;
    CallerCounts counts; ///< for each caller that connects them
    bool live = false;   ///< current flows through it
    bool forward = true; ///< it flows from a to b
    bool line = false;   ///< is drawn although it conducts only at times, see addGeneratorLines()
    bool inside = false; ///< runs within a joint that holds both and is not drawn (look "none"), as in the
                         ///< links of a chain
};

/// All connections of a world's electricity graph, ascending by pair. Empty where there is no electricity.
[[nodiscard]] std::vector<Link> linksOf(World const& world);

/// Of a cable in the world, m.
inline constexpr double cableWidth = 0.045;

/// Returns the pose at which an object is drawn.
using PoseOf = std::function<Pose(Facts const&)>;

/// The line along which a cable hangs between two objects, from a to b. At an object welded to a body that
/// turns freely about the world it begins at that body's axle.
[[nodiscard]] std::vector<Point> cablePath(Facts const& a, Pose const& poseA, Facts const& b,
                                           Pose const& poseB);

/// Whether a wire between the two objects of a joint runs inside the joint and is not drawn: the joint has
/// the look "none" and holds them together.
[[nodiscard]] bool hidesWires(Joint const& joint);

/// The current in a cable that is drawn.
struct CableCurrent {
    bool live = false;
    bool forward = true; ///< from a to b
    double time = 0;     ///< s; moves the beads
};

/// A generator is connected to its source only while it turns. Where the source is only a sign, which would
/// be unconnected otherwise, the line between the two is to be drawn all the time: adds it to the links, or
/// marks the existing one.
void addGeneratorLines(World const& world, std::vector<Link>& links);

/// How a cable of a certain length lies on a table between two places at the same height, as it is shown in
/// the toolbox: it sags, and if there is enough of it, it makes a loop. `length` in m.
[[nodiscard]] std::vector<Point> loopedCable(Point from, Point to, double length);

/// Draws a cable along a path from a to b, with its ends; `width` in m.
void drawCableAlong(Canvas& canvas, std::vector<Point> path, Facts const& a, Facts const& b, double width,
                    CableCurrent const& current = {});
/// Draws one cable, from a to b, with its ends, as it hangs in the world.
void drawCable(Canvas& canvas, Facts const& a, Pose const& poseA, Facts const& b, Pose const& poseB,
               CableCurrent const& current = {});

/// Draws every wire that the level has laid, unless it is inside a joint, and the lines of generators; other
/// connections that interactions make are not drawn. `time` in s moves the beads of current.
void drawWires(Canvas& canvas, FactsReader const& reader, std::vector<Link> const& links,
               PoseOf const& poseOf, double time);

/// The wire that drawWires() draws whose cable runs within `tolerance` metres of a point; both ids are
/// invalid if there is none.
[[nodiscard]] Link pickWire(World const& world, Point at, double tolerance);

} // namespace trembler::render
