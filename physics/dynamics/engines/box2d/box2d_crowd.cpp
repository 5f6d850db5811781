#include "physics/dynamics/engines/box2d/box2d_crowd.hpp"

namespace trembler {
namespace {

// The number of contacts with movable bodies, counted up to the limit.
int countMoving(b2Body* body) {
    int count = 0;
    for (b2ContactEdge* edge = body->GetContactList(); edge != nullptr && count < CrowdFilter::mostContacts;
         edge = edge->next) {
        count += edge->other->GetType() == b2_dynamicBody ? 1 : 0;
    }
    return count;
}

} // namespace

CrowdFilter::Crowd& CrowdFilter::crowdOf(b2Body* body) {
    std::uintptr_t const number = body->GetUserData().pointer;
    if (crowds_.size() <= number) {
        crowds_.resize(number + 1);
    }
    return crowds_[number];
}

bool CrowdFilter::isCrowded(b2Body* body) {
    Crowd& crowd = crowdOf(body);
    if (crowd.atMost < mostContacts) {
        return false;
    }
    if (crowd.fullIn != turn_) {
        crowd.atMost = countMoving(body);
        if (crowd.atMost < mostContacts) {
            return false;
        }
        crowd.fullIn = turn_;
    }
    return true;
}

bool CrowdFilter::ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) {
    if (!b2ContactFilter::ShouldCollide(fixtureA, fixtureB)) {
        return false;
    }
    b2Body* const a = fixtureA->GetBody();
    b2Body* const b = fixtureB->GetBody();
    // No contact is created without calling this function. So while the number of contacts is as expected,
    // none has been destroyed, and crowded bodies are still crowded.
    int32 const contacts = a->GetWorld()->GetContactCount();
    if (contacts != expected_) {
        ++turn_;
    }
    bool const bothMove = a->GetType() == b2_dynamicBody && b->GetType() == b2_dynamicBody;
    bool const may = !bothMove || !isCrowded(a) || !isCrowded(b);
    if (bothMove && may) {
        ++crowdOf(a).atMost;
        ++crowdOf(b).atMost;
    }
    expected_ = contacts + (may ? 1 : 0);
    return may;
}

} // namespace trembler
