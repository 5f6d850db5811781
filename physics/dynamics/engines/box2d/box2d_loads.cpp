// Applies external forces, drag and damping to the bodies in each substep.
#include "physics/dynamics/engines/box2d/box2d_engine.hpp"

namespace trembler {

void Box2dEngine::setLoads(std::span<Load const> loads) {
    loadWoken();
    world_.ClearForces();
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        BodyEntry& entry = bodies_[slot];
        if (entry.body == nullptr) {
            continue;
        }
        Load const load = slot < loads.size() ? loads[slot] : Load{};
        entry.force = toEngine(load.force);
        entry.torque = static_cast<float>(load.torque * scale_ * scale_);
        if (awake_[slot] != 0) {
            entry.body->ApplyForceToCenter(entry.force, false);
            entry.body->ApplyTorque(entry.torque, false);
        }
    }
}

void Box2dEngine::setDrags(std::span<Drag const> drags) {
    draggedSlots_.clear();
    dragged_.resize(drags.empty() ? 0 : bodies_.size());
    for (SlotIndex slot = 0; slot < dragged_.size(); ++slot) {
        b2Body const* const body = bodies_[slot].body;
        if (slot < drags.size() && drags[slot].any() && body != nullptr &&
            body->GetType() == b2_dynamicBody) {
            dragged_[slot].drag = drags[slot];
            draggedSlots_.push_back(slot);
        } else {
            dragged_[slot] = {};
        }
    }
}

Twist Box2dEngine::momentumOf(b2Body const& body) const {
    return {static_cast<double>(body.GetMass()) * fromEngine(body.GetLinearVelocity()),
            static_cast<double>(body.GetInertia()) / (scale_ * scale_) *
                static_cast<double>(body.GetAngularVelocity())};
}

void Box2dEngine::applyDrags(double substep) {
    double const square = scale_ * scale_;
    for (SlotIndex const slot : draggedSlots_) {
        BodyEntry const& entry = bodies_[slot];
        if (entry.body == nullptr || awake_[slot] == 0) {
            continue;
        }
        Twist const load{substep * fromEngine(entry.force),
                         substep * static_cast<double>(entry.torque) / square};
        Twist const impulse = dragged_[slot].before(static_cast<double>(entry.body->GetMass()),
                                                    static_cast<double>(entry.body->GetInertia()) / square,
                                                    momentumOf(*entry.body), load, substep);
        entry.body->ApplyLinearImpulseToCenter(toEngine(impulse.linear), false);
        entry.body->ApplyAngularImpulse(static_cast<float>(impulse.angular * square), false);
    }
}

void Box2dEngine::noteDragged() {
    for (SlotIndex const slot : draggedSlots_) {
        if (bodies_[slot].body != nullptr && awake_[slot] != 0) {
            dragged_[slot].after(momentumOf(*bodies_[slot].body));
        }
    }
}

} // namespace trembler
