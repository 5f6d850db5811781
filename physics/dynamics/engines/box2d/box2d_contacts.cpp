// Contacts, their contact forces and impacts, as reported by Box2D.
#include "physics/dynamics/engines/box2d/box2d_engine.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler {
namespace {

ImpactBook::Key keyOf(b2Contact const* contact) {
    return reinterpret_cast<std::uintptr_t>(contact);
}

} // namespace

void Box2dEngine::BeginContact(b2Contact* contact) {
    if (watching_ && onTheWay(contact)) {
        noteOnTheWay(contact, false);
    }
    noteTouch(contact, 1);
    if (impactsWanted_) {
        pressures_.begin(keyOf(contact));
    }
}

void Box2dEngine::noteOnTheWay(b2Contact* contact, bool ended) {
    for (b2Fixture* const fixture : {contact->GetFixtureA(), contact->GetFixtureB()}) {
        b2Body const& body = *fixture->GetBody();
        if (body.GetType() == b2_dynamicBody) {
            changedOnTheWay_.push_back({slotOf(&body), {body.GetPosition(), body.GetAngle()}, ended});
        }
    }
}

bool Box2dEngine::onTheWay(b2Contact* contact) const {
    for (b2Fixture* const fixture : {contact->GetFixtureA(), contact->GetFixtureB()}) {
        b2Body const& body = *fixture->GetBody();
        if (body.GetType() == b2_dynamicBody) {
            Place const& start = start_[slotOf(&body)];
            if (!(body.GetPosition() == start.centre) || body.GetAngle() != start.angle) {
                return true;
            }
        }
    }
    return false;
}

void Box2dEngine::EndContact(b2Contact* contact) {
    if (watching_ && !contact->IsTouching() &&
        onTheWay(contact)) { // a contact that is destroyed still counts as touching here
        noteOnTheWay(contact, true);
    }
    noteTouch(contact, -1);
    pressures_.end(keyOf(contact));
}

float Box2dEngine::speedGain(b2Body const* body) const {
    SlotIndex const slot = slotOf(body);
    float const mass = body->GetMass();
    if (slot == noSlot || !(mass > 0)) {
        return 0;
    }
    BodyEntry const& entry = bodies_[slot];
    float gain = entry.force.Length() / mass;
    if (entry.torque != 0) {
        // Box2D's moment of inertia is about the body's origin.
        float const inertia = body->GetInertia() - mass * body->GetLocalCenter().LengthSquared();
        gain += std::abs(entry.torque) * static_cast<float>(entry.extent * scale_) / inertia;
    }
    return gain * substep_;
}

// A body that is pressed or turned against another by a strong load gains a speed in every substep that looks
// like an impact; bouncing it back would never end. Only speed that the load does not explain bounces.
void Box2dEngine::PreSolve(b2Contact* contact, b2Manifold const*) {
    if (impactsWanted_) {
        for (b2Fixture const* const fixture : {contact->GetFixtureA(), contact->GetFixtureB()}) {
            b2Body const* const body = fixture->GetBody();
            beforeTouch_[slotOf(body)] = {body->GetLinearVelocity(), body->GetAngularVelocity()};
        }
    }
    if (contact->GetRestitution() > 0) {
        float const explained =
            2 * (speedGain(contact->GetFixtureA()->GetBody()) + speedGain(contact->GetFixtureB()->GetBody()));
        contact->SetRestitutionThreshold(std::max(b2FixtureDef().restitutionThreshold, explained));
    }
}

void Box2dEngine::noteImpacts(bool wanted) {
    if (impactsWanted_ && !wanted) {
        pressures_.clear();
        impacts_.clear();
    }
    impactsWanted_ = wanted;
}

void Box2dEngine::PostSolve(b2Contact* contact, b2ContactImpulse const* impulse) {
    if (!impactsWanted_) {
        return;
    }
    float sum = 0;
    for (int i = 0; i < impulse->count; ++i) {
        sum += impulse->normalImpulses[i];
    }
    double const newImpulse = pressures_.press(keyOf(contact), static_cast<double>(sum));
    b2Body const* const a = contact->GetFixtureA()->GetBody();
    b2Body const* const b = contact->GetFixtureB()->GetBody();
    auto const inverse = [](b2Body const* body) {
        return body->GetMass() > 0 ? 1 / static_cast<double>(body->GetMass()) : 0;
    };
    if (!(newImpulse * (inverse(a) + inverse(b)) > faintestImpact * scale_)) {
        return;
    }
    b2WorldManifold world;
    contact->GetWorldManifold(&world);
    Impact impact;
    impact.a = bodies_[slotOf(a)].object;
    impact.b = bodies_[slotOf(b)].object;
    impact.normal = {static_cast<double>(world.normal.x), static_cast<double>(world.normal.y)};
    if (impact.b < impact.a) {
        std::swap(impact.a, impact.b);
        impact.normal = -impact.normal;
    }
    for (int i = 0; i < impulse->count; ++i) {
        double const share = static_cast<double>(impulse->normalImpulses[i]) / static_cast<double>(sum);
        impact.point += share * fromEngine(world.points[i]);
    }
    impact.impulse = newImpulse / scale_;
    impact.since = since_;
    bool const inOrder = impact.a == bodies_[slotOf(a)].object;
    budget_.add(impact, slotOf(a->GetType() == b2_dynamicBody ? a : b), beforeImpact(inOrder ? a : b),
                beforeImpact(inOrder ? b : a));
}

ImpactBudget::Body Box2dEngine::beforeImpact(b2Body const* body) const {
    if (body->GetType() != b2_dynamicBody) {
        return {};
    }
    Velocity const& before = beforeTouch_[slotOf(body)];
    return {.inverseMass = 1 / static_cast<double>(body->GetMass()),
            .inverseInertia = scale_ * scale_ / static_cast<double>(body->GetInertia()),
            .centre = fromEngine(body->GetPosition()),
            .velocity = fromEngine(before.linear),
            .spin = static_cast<double>(before.spin)};
}

void Box2dEngine::noteVelocities() {
    if (!impactsWanted_) {
        return;
    }
    budget_.begin();
    atStart_.resize(bodies_.size());
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        if (b2Body const* const body = bodies_[slot].body; body != nullptr) {
            atStart_[slot] = {body->GetLinearVelocity(), body->GetAngularVelocity()};
        }
    }
    beforeTouch_ = atStart_;
}

void Box2dEngine::settleImpacts() {
    if (!impactsWanted_) {
        return;
    }
    if (budget_.exceeded()) {
        budget_.reset(bodies_.size());
        auto const link = [this](b2Body const* a, b2Body const* b) {
            if (a->GetType() == b2_dynamicBody && b->GetType() == b2_dynamicBody) {
                budget_.link(slotOf(a), slotOf(b));
            }
        };
        for (b2Contact const* contact = world_.GetContactList(); contact != nullptr;
             contact = contact->GetNext()) {
            if (contact->IsTouching()) {
                link(contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody());
            }
        }
        for (JointEntry const& entry : joints_) {
            if (entry.joint != nullptr) {
                link(entry.joint->GetBodyA(), entry.joint->GetBodyB());
            }
        }
        for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
            b2Body const* const body = bodies_[slot].body;
            if (body == nullptr || body->GetType() != b2_dynamicBody) {
                continue;
            }
            auto const energy = [&](b2Vec2 velocity, float spin) {
                return kineticEnergy(static_cast<double>(body->GetMass()),
                                     static_cast<double>(body->GetInertia()) / (scale_ * scale_),
                                     fromEngine(velocity), static_cast<double>(spin));
            };
            budget_.lose(slot, energy(atStart_[slot].linear, atStart_[slot].spin) -
                                   energy(body->GetLinearVelocity(), body->GetAngularVelocity()));
        }
    }
    budget_.settle(impacts_);
}

TouchChange Box2dEngine::changeOf(b2Contact* contact, int delta) const {
    ObjectId const a = bodies_[slotOf(contact->GetFixtureA()->GetBody())].object;
    ObjectId const b = bodies_[slotOf(contact->GetFixtureB()->GetBody())].object;
    return a < b ? TouchChange{a, b, delta} : TouchChange{b, a, delta};
}

void Box2dEngine::noteTouch(b2Contact* contact, int delta) {
    TouchChange const change = changeOf(contact, delta);
    if (!takeReported(contact, change)) {
        touches_.push_back(change);
    }
    for (b2Body* const body : {contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody()}) {
        if (body->IsAwake()) {
            wakeAll(body); // Box2D has just woken it, because a contact has begun or ended
        }
    }
}

void Box2dEngine::addContactPatches(std::vector<ContactPatch>& patches) const {
    // Box2D has no other access to the contacts of a const world.
    for (b2Contact* contact = const_cast<b2World&>(world_).GetContactList(); contact != nullptr;
         contact = contact->GetNext()) {
        std::optional<b2Manifold> const touching = manifoldNow(contact);
        if (!touching || touching->pointCount == 0) {
            continue;
        }
        b2Manifold const& manifold = *touching;
        b2WorldManifold world;
        world.Initialize(&manifold, contact->GetFixtureA()->GetBody()->GetTransform(),
                         contact->GetFixtureA()->GetShape()->m_radius,
                         contact->GetFixtureB()->GetBody()->GetTransform(),
                         contact->GetFixtureB()->GetShape()->m_radius);
        ContactPatch patch;
        patch.a = bodies_[slotOf(contact->GetFixtureA()->GetBody())].object;
        patch.b = bodies_[slotOf(contact->GetFixtureB()->GetBody())].object;
        double const sign = patch.a < patch.b ? 1 : -1;
        if (sign < 0) {
            std::swap(patch.a, patch.b);
        }
        patch.normal = sign * Vec2{static_cast<double>(world.normal.x), static_cast<double>(world.normal.y)};
        patch.count = manifold.pointCount;
        for (int i = 0; i < manifold.pointCount; ++i) {
            auto const n = static_cast<std::size_t>(i);
            patch.points[n] = fromEngine(world.points[i]);
            patch.normalImpulse[n] = static_cast<double>(manifold.points[i].normalImpulse) / scale_;
            patch.tangentImpulse[n] = static_cast<double>(manifold.points[i].tangentImpulse) / scale_;
        }
        patches.push_back(patch);
    }
}

} // namespace trembler
