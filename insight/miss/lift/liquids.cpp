#include "insight/miss/lift/liquids.hpp"

#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shapes/shape_order.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "runtime/placement.hpp"

#include <algorithm>

namespace trembler::insight::load {

Liquids::Liquids(World const& world, Vec2 gravity) : gravity_(gravity) {
    auto const* const column = world.store().findColumn<Liquid>();
    if (column == nullptr) {
        return;
    }
    for (ObjectId const id : column->owners()) {
        Shape const* const shape = world.find<Shape>(id);
        Position const* const position = world.find<Position>(id);
        if (shape == nullptr || position == nullptr || faultIn(*shape)) {
            continue;
        }
        Rotation const* const rotation = world.find<Rotation>(id);
        Density const* const density = world.find<Density>(id);
        Pose const pose(position->value, rotation == nullptr ? 0 : rotation->angle);
        liquids_.push_back({id, (density == nullptr ? Density{} : *density).value, pose.turned({0, 1}),
                            liquidPieces(inOrder(*shape), pose)});
    }
}

std::vector<ActingForce> Liquids::on(Body const& body, Vec2 by) const {
    std::vector<ActingForce> forces;
    ExactHull const hull(*body.shape);
    Pose pose = body.pose;
    pose.at += by;
    for (One const& liquid : liquids_) {
        Displacement sum;
        for (LiquidPiece const& piece : liquid.pieces) {
            sum += displacedOf(hull, piece, pose, liquid.up);
        }
        double const strength =
            liquid.density * sum.wet.area * worldDepth * std::max(0.0, -dot(gravity_, liquid.up));
        if (strength <= 0) {
            continue;
        }
        forces.push_back({strength * liquid.up, pose.toWorld(sum.wet.centroid()), liquid.id});
    }
    return forces;
}

} // namespace trembler::insight::load
