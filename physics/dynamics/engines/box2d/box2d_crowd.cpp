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

bool CrowdFilter::isCrowded(b2Body* body) {
    std::uintptr_t const number = body->GetUserData().pointer;
    if (crowdedAt_.size() <= number) {
        crowdedAt_.resize(number + 1, 0);
    }
    if (crowdedAt_[number] != turn_ && crowded(body)) {
        crowdedAt_[number] = turn_;
    }
    return crowdedAt_[number] == turn_;
}

bool CrowdFilter::ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) {
    if (!b2ContactFilter::ShouldCollide(fixtureA, fixtureB)) {
        return false;
    }
    b2Body* const a = fixtureA->GetBody();
    b2Body* const b = fixtureB->GetBody();
    // No contact is created without calling this function, so as long as their number is as expected none has
    // been destroyed, and crowded bodies are still crowded.
    int32 const contacts = a->GetWorld()->GetContactCount();
    if (contacts != expected_) {
        ++turn_;
    }
    bool const may =
        a->GetType() != b2_dynamicBody || b->GetType() != b2_dynamicBody || !isCrowded(a) || !isCrowded(b);
    expected_ = contacts + (may ? 1 : 0);
    return may;
}

} // namespace trembler
