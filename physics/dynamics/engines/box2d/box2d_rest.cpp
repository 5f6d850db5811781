// Sleeping and waking: Box2D's own state, and the loads of sleeping bodies.
#include "physics/dynamics/engines/box2d/box2d_engine.hpp"
#include "physics/dynamics/engines/sleep_limits.hpp"

#include <cmath>
#include <utility>

namespace trembler {
void Box2dEngine::wake(SlotIndex slot) {
    wakeAll(bodies_[slot].body);
}

void Box2dEngine::wakeAll(b2Body* body) {
    wakeStack_.push_back(body);
    while (!wakeStack_.empty()) {
        b2Body& next = *wakeStack_.back();
        wakeStack_.pop_back();
        SlotIndex const slot = slotOf(&next);
        if (next.GetType() != b2_dynamicBody || slot == noSlot || awake_[slot] != 0) {
            continue;
        }
        next.SetAwake(true);
        next.ApplyForceToCenter(bodies_[slot].force, false);
        next.ApplyTorque(bodies_[slot].torque, false);
        awake_[slot] = 1;
        anyAwake_ = true;
        for (b2ContactEdge* edge = next.GetContactList(); edge != nullptr; edge = edge->next) {
            if (edge->contact->IsTouching() && edge->contact->IsEnabled()) {
                wakeStack_.push_back(edge->other);
            }
        }
        for (b2JointEdge* edge = next.GetJointList(); edge != nullptr; edge = edge->next) {
            wakeStack_.push_back(edge->other);
        }
    }
}

// Box2D also wakes bodies by itself: when a body that they rested on is destroyed, or when sleeping is
// disabled.
void Box2dEngine::loadWoken() {
    if (!std::exchange(disturbed_, false)) {
        return;
    }
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        b2Body* const body = bodies_[slot].body;
        if (body != nullptr && awake_[slot] == 0 && body->GetType() == b2_dynamicBody && body->IsAwake()) {
            wakeAll(body);
        }
    }
}

void Box2dEngine::keepAwake(SlotIndex slot, int change) {
    BodyEntry& entry = bodies_[slot];
    entry.restlessJoints += change;
    if (entry.body->GetType() == b2_dynamicBody &&
        entry.body->IsSleepingAllowed() != (entry.restlessJoints == 0)) {
        wakeAll(entry.body);
        entry.body->SetSleepingAllowed(entry.restlessJoints == 0);
    }
}

bool Box2dEngine::drifts(BodyEntry const& entry) const {
    b2Body& body = *entry.body;
    float const tolerance = b2_linearSleepTolerance;
    if (body.GetLinearVelocity().LengthSquared() > tolerance * tolerance) {
        return false; // too fast to fall asleep
    }
    if (body.GetJointList() != nullptr) {
        return false;
    }
    for (b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
        if (edge->contact->IsTouching()) {
            return false;
        }
    }
    return length(fromEngine(entry.force)) > driftAcceleration * static_cast<double>(body.GetMass()) ||
           length(fromEngine(body.GetLinearVelocity())) > driftSpeed ||
           std::abs(static_cast<double>(body.GetAngularVelocity())) > driftSpin;
}

} // namespace trembler
