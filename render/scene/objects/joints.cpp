#include "render/scene/objects/joints.hpp"

#include "physics/dynamics/properties/joint_anchors.hpp"
#include "render/draw/path.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/objects/joint_parts.hpp"
#include "render/scene/objects/ties.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::render {
namespace {

constexpr int ropePieces = 24;

// The largest disc about the pin; without one, a disc that follows from the ratio and the distance.
double wheelRadius(Facts const& wheel, double pitch) {
    double radius = 0;
    if (wheel.shape != nullptr) {
        for (ShapePiece const& piece : wheel.shape->pieces) {
            radius = std::max(radius, piece.form == ShapeForm::circle ? piece.radius : 0);
        }
    }
    return radius > 0 ? radius : pitch;
}

} // namespace

std::optional<JointPlaces> placesOf(World const& world, FactsReader const& reader, ObjectId joint,
                                    PoseOf const& poseOf) {
    Joint const* const stated = world.find<Joint>(joint);
    Facts const a = stated == nullptr ? Facts{} : reader.of(stated->a);
    if (a.position == nullptr) {
        return std::nullopt;
    }
    JointPlaces places;
    places.toWorld = !stated->b.valid();
    Pose frameB;
    if (!places.toWorld) {
        Facts const b = reader.of(stated->b);
        if (b.position == nullptr) {
            return std::nullopt;
        }
        frameB = poseOf(b);
    }
    Pose const frameA = poseOf(a);
    places.angleA = frameA.angle;
    places.angleB = frameB.angle;
    if (JointAnchors const* const anchors = world.find<JointAnchors>(joint); anchors != nullptr) {
        places.a = toWorld(frameA, toPoint(anchors->onA));
        places.b = toWorld(frameB, toPoint(anchors->onB));
        places.axis = toWorld({{}, frameB.angle}, toPoint(anchors->axis));
        places.length = anchors->length;
        return places;
    }
    JointPlaces const atStart = statedPlaces(*stated);
    places.a = atStart.a;
    places.b = atStart.b;
    places.axis = atStart.axis;
    places.length = atStart.length;
    return places;
}

JointPlaces statedPlaces(Joint const& joint) {
    JointPlaces places;
    places.toWorld = !joint.b.valid();
    bool const twoEnds = joint.form == JointForm::distance || joint.form == JointForm::rope ||
                         joint.form == JointForm::spring || joint.form == JointForm::pulley;
    places.a = toPoint(joint.at);
    places.b = toPoint(twoEnds ? joint.atB : joint.at);
    double const size = length(joint.axis);
    places.axis = size > 0 ? toPoint(joint.axis / size) : Point{1, 0};
    places.length = joint.length;
    return places;
}

void drawGear(Canvas& canvas, Joint const& joint, Facts const& a, Facts const& b, JointPlaces const& pinA,
              JointPlaces const& pinB) {
    JointDrawn const look = joint.look.drawn;
    if (look == JointDrawn::none) {
        return;
    }
    if (look != JointDrawn::belt && look != JointDrawn::chain) {
        drawGearPitch(canvas, pinA.a, pinB.a, joint.ratio);
        return;
    }
    double const share = std::abs(joint.ratio);
    double const pitch = 0.6 * length(pinB.a - pinA.a) / (1 + share);
    BeltWheel const wheelA{pinA.a, wheelRadius(a, pitch)};
    BeltWheel const wheelB{pinB.a, wheelRadius(b, pitch * share)};
    std::vector<Point> const path = beltPath(wheelA, wheelB, joint.ratio > 0);
    drawTie(canvas, look, path, pinA.angleA * wheelA.radius);
}

std::vector<Point> ropePath(Point from, Point to, double length) {
    double const span = render::length(to - from);
    if (!(length > 1.001 * span)) {
        return {from, to};
    }
    // The deeper a parabola hangs, the longer it is: halve the interval until it is as long as the rope.
    double shallow = 0;
    double deep = length;
    for (int i = 0; i < 24; ++i) {
        double const sag = 0.5 * (shallow + deep);
        (pathLength(hangingWire(from, to, sag, ropePieces)) < length ? shallow : deep) = sag;
    }
    return hangingWire(from, to, 0.5 * (shallow + deep), ropePieces);
}

void drawJoints(Canvas& canvas, World const& world, FactsReader const& reader, PoseOf const& poseOf,
                std::span<ObjectId const> hidden) {
    auto const* const joints = world.store().findColumn<Joint>();
    if (joints == nullptr) {
        return;
    }
    for (ObjectId const id : joints->owners()) {
        Joint const& joint = (*joints)[id];
        auto const places = placesOf(world, reader, id, poseOf);
        if (!places || std::find(hidden.begin(), hidden.end(), id) != hidden.end()) {
            continue;
        }
        if (joint.form == JointForm::gear) {
            auto const pinA = placesOf(world, reader, joint.jointA, poseOf);
            auto const pinB = placesOf(world, reader, joint.jointB, poseOf);
            if (pinA && pinB) {
                drawGear(canvas, joint, reader.of(joint.a), reader.of(joint.b), *pinA, *pinB);
            }
            continue;
        }
        drawJoint(canvas, joint, *places);
    }
}

} // namespace trembler::render
