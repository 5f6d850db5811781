#include "physics/dynamics/engines/box2d/box2d_crowd.hpp"

namespace trembler {
namespace {

bool crowded(b2Body* body) {
    int count = 0;
    for (b2ContactEdge* edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
        if (edge->other->GetType() == b2_dynamicBody && ++count >= CrowdFilter::mostContacts) {
            return true;
        }
    }
    return false;
}

} // namespace

bool CrowdFilter::ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) {
    if (!b2ContactFilter::ShouldCollide(fixtureA, fixtureB)) {
        return false;
    }
    b2Body* const a = fixtureA->GetBody();
    b2Body* const b = fixtureB->GetBody();
    return a->GetType() != b2_dynamicBody || b->GetType() != b2_dynamicBody || !crowded(a) || !crowded(b);
}

} // namespace trembler
