#include "physics/dynamics/core/bodies.hpp"

#include "physics/dynamics/properties/shapes/shape_order.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

template <class P>
P valueOr(Column<P> const& column, ObjectId id, P fallback = {}) {
    P const* const found = column.find(id);
    return found == nullptr ? fallback : *found;
}

bool within(Vec2 v, double limit) {
    return isFinite(v) && std::abs(v.x) <= limit && std::abs(v.y) <= limit;
}

bool sameTraits(BodySpec const& a, BodySpec const& b) {
    return a.fixed == b.fixed && a.bullet == b.bullet && (a.mass == b.mass || a.fixed) &&
           a.friction == b.friction && a.restitution == b.restitution && a.groups == b.groups &&
           a.damping == b.damping;
}

std::optional<std::string> faultInTraits(BodySpec const& spec) {
    auto const between = [](double value, double low, double high) { return value >= low && value <= high; };
    if (!spec.fixed && !between(spec.mass, 1e-6, 1e9)) {
        return fmt::format("its mass is {} kg; expected 1e-6 to 1e9 kg", spec.mass);
    }
    if (!between(spec.friction, 0, 100) || !between(spec.restitution, 0, 1)) {
        return fmt::format("its friction is {} and its restitution {}; expected 0 to 100 and 0 to 1",
                           spec.friction, spec.restitution);
    }
    if (!between(spec.damping.linear, 0, 1e3) || !between(spec.damping.angular, 0, 1e3)) {
        return fmt::format("its damping is {} and {} 1/s; expected 0 to 1000 1/s", spec.damping.linear,
                           spec.damping.angular);
    }
    return std::nullopt;
}

std::optional<std::string> faultInMotion(Motion const& motion) {
    if (!within(motion.centre, maximumDistance) || !(std::abs(motion.angle) <= 1e6)) {
        return fmt::format("it is at [{}, {}] m, turned by {} rad; expected at most {} m from the origin",
                           motion.centre.x, motion.centre.y, motion.angle, maximumDistance);
    }
    if (!within(motion.velocity, maximumSpeed) || !(std::abs(motion.spin) <= 1e4)) {
        return fmt::format("it moves at [{}, {}] m/s and {} rad/s; expected at most {} of each",
                           motion.velocity.x, motion.velocity.y, motion.spin, maximumSpeed);
    }
    return std::nullopt;
}

bool canMove(DynamicsColumns const& columns, ObjectId id) {
    return columns.rotation.has(id) && columns.velocity.has(id) && columns.spin.has(id);
}

Motion motionOf(DynamicsColumns const& columns, ObjectId id, Vec2 centre) {
    double const angle = valueOr(columns.rotation, id).angle;
    Vec2 const position = valueOr(columns.position, id).value;
    return {centre == Vec2{} ? position : position + rotated(centre, angle), angle,
            valueOr(columns.velocity, id).value, valueOr(columns.spin, id).value};
}

} // namespace

// Everything except the shape, its mass distribution and the body's motion.
BodySpec BodyTable::traitsOf(DynamicsColumns const& columns, ObjectId id) const {
    BodySpec spec;
    spec.object = id;
    spec.fixed = columns.fixed.has(id) || std::binary_search(still_.begin(), still_.end(), id);
    spec.bullet = columns.bullet.has(id);
    spec.mass = spec.fixed ? Mass{}.value : valueOr(columns.mass, id).value; // a fixed body never moves
    spec.friction = valueOr(columns.friction, id).coefficient;
    spec.restitution = valueOr(columns.restitution, id).coefficient;
    spec.groups = valueOr(columns.groups, id);
    spec.damping = valueOr(columns.damping, id);
    return spec;
}

std::vector<SlotIndex> BodyTable::outdated(DynamicsColumns const& columns) const {
    std::vector<SlotIndex> found;
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        Body const& body = bodies_[slot];
        if (!body.object.valid()) {
            continue;
        }
        Shape const* const shape = columns.shape.find(body.object);
        bool const placed =
            columns.position.has(body.object) && (body.fixed || canMove(columns, body.object));
        if (shape == nullptr || !placed || columns.liquid.has(body.object) || !(*shape == body.shape) ||
            !sameTraits(traitsOf(columns, body.object), body.spec)) {
            found.push_back(slot);
        }
    }
    return found;
}

void BodyTable::remove(SlotIndex slot, Engine& engine) {
    engine.removeBody(slot);
    slots_.release(slot);
    bodies_[slot] = {};
}

void BodyTable::addMissing(DynamicsColumns const& columns, Engine& engine, std::vector<Refusal>& refusals) {
    std::span<ObjectId const> const owners = columns.shape.owners();
    for (std::size_t row = 0; row < owners.size(); ++row) {
        ObjectId const id = owners[row];
        if (slotOf(id) != noSlot || columns.liquid.has(id)) {
            continue; // liquids have no collisions (6.13.2)
        }
        Body body;
        body.shape = columns.shape.values()[row];
        body.spec = traitsOf(columns, id);
        std::optional<std::string> fault = faultIn(body.shape);
        if (!fault) {
            fault = faultInTraits(body.spec);
        }
        if (!fault && !columns.position.has(id)) {
            fault = "it has a shape but no place; expected a position";
        }
        if (!fault && !body.spec.fixed && !canMove(columns, id)) {
            fault = "it can move but has no rotation, velocity or angular velocity";
        }
        if (!fault) {
            body.spec.spread = massPropertiesOf(body.shape);
            body.spec.motion = motionOf(columns, id, body.spec.spread.centre);
            fault = faultInMotion(body.spec.motion);
        }
        if (fault) {
            refusals.push_back({id, *fault});
            continue;
        }
        body.object = id;
        body.fixed = body.spec.fixed;
        body.mass = body.spec.mass;
        body.inertia = body.spec.mass * body.spec.spread.inertiaPerMass;
        body.centre = body.spec.spread.centre;
        body.offCentre = !(body.centre == Vec2{});
        SlotIndex const slot = slots_.take(id);
        bodies_.resize(slots_.objects().size());
        bodies_[slot] = std::move(body);
        Shape const ordered = inOrder(bodies_[slot].shape);
        bodies_[slot].spec.shape = &ordered;
        engine.addBody(slot, bodies_[slot].spec);
        bodies_[slot].spec.shape = nullptr; // only the engine uses it, during addBody()
    }
}

void BodyTable::followMotion(DynamicsColumns const& columns, Engine& engine) {
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        Body const& body = bodies_[slot];
        if (!body.object.valid()) {
            continue;
        }
        Motion const motion = motionOf(columns, body.object, body.centre);
        if (!faultInMotion(motion) && !engine.isAt(slot, motion)) {
            engine.place(slot, motion);
        }
    }
}

void BodyTable::findRows(DynamicsColumns const& columns) {
    for (Body& body : bodies_) {
        if (body.object.valid() && !body.fixed) {
            body.rows = {columns.position.row(body.object), columns.rotation.row(body.object),
                         columns.velocity.row(body.object), columns.spin.row(body.object)};
        }
    }
}

} // namespace trembler
