// Touches at the end of a frame that Box2D has not evaluated yet.
//
// Box2D evaluates a contact at the beginning of a substep, and some contacts again where it stops a fast body
// on its path. Bodies that are wedged are then moved by the correction of overlaps, by some hundredths of a
// metre in a substep, and fast ones move as far by their speed. Contacts of two bodies that moved far
// relative to each other are therefore evaluated again at the end of the frame, and differences are reported
// as touches that began or ended. Box2D finds the same at the beginning of the next substep; that second
// report is dropped. Box2D's own state is not changed: a step of zero duration would find the same touches,
// but it changes what Box2D starts its next step from, and evaluates all contacts instead of a few.
#include "physics/dynamics/engines/box2d/box2d_engine.hpp"

#include <algorithm>
#include <utility>

namespace trembler {

// The same conditions as in Box2D for evaluating a contact and for a touch.
bool Box2dEngine::isStale(b2Contact* contact) {
    b2Body const* const a = contact->GetFixtureA()->GetBody();
    b2Body const* const b = contact->GetFixtureB()->GetBody();
    if (!isActive(*a) && !isActive(*b)) {
        return false;
    }
    Overlap const overlap = overlapOf(*contact->GetFixtureA()->GetShape(), a->GetTransform(),
                                      *contact->GetFixtureB()->GetShape(), b->GetTransform());
    if (overlap != Overlap::unknown) {
        return (overlap == Overlap::certain) != contact->IsTouching();
    }
    b2Manifold now;
    contact->Evaluate(&now, a->GetTransform(), b->GetTransform());
    return (now.pointCount > 0) != contact->IsTouching();
}

SubstepMotion Box2dEngine::motionFrom(SlotIndex slot, Place const& start) const {
    b2Body const& body = *bodies_[slot].body;
    return {start.centre, body.GetPosition(), body.GetAngle() - start.angle,
            static_cast<float>(bodies_[slot].extent * scale_)};
}

// Measured by positions, not by velocities: the correction of overlaps moves bodies that have no velocity,
// and may even move one back to where it was at the beginning of the substep.
void Box2dEngine::noteSubstepMotions() {
    substepMotions_.resize(bodies_.size());
    movedFar_.assign(bodies_.size(), Moved::little);
    farSlots_.clear();
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (bodies_[slot].body != nullptr) {
            substepMotions_[slot] = motionFrom(slot, start_[slot]);
            if (awake_[slot] != 0 && movedFar(substepMotions_[slot], farLimit())) {
                movedFar_[slot] = Moved::far;
                farSlots_.push_back(slot);
            }
        }
    }
    for (OnTheWay const& change : changedOnTheWay_) {
        Moved& moved = movedFar_[change.slot];
        if (moved != Moved::stopped &&
            (change.ended || movedFar(motionFrom(change.slot, change.place), farLimit()))) {
            if (moved == Moved::little) {
                farSlots_.insert(std::lower_bound(farSlots_.begin(), farSlots_.end(), change.slot),
                                 change.slot);
            }
            moved = Moved::stopped;
        }
    }
}

// If many bodies move together, as in a drum or on a vehicle, few bodies deviate from the motion of the
// largest one, and pairs of the others have not moved relative to each other.
bool Box2dEngine::findDeviating() {
    deviating_.clear();
    SlotIndex largest = noSlot;
    for (SlotIndex const slot : farSlots_) {
        if (movedFar_[slot] == Moved::stopped) {
            return false;
        }
        if (largest == noSlot || substepMotions_[slot].extent > substepMotions_[largest].extent) {
            largest = slot;
        }
    }
    if (farSlots_.size() < 2) {
        return false;
    }
    deviates_.assign(bodies_.size(), 0);
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (bodies_[slot].body != nullptr &&
            deviatesFrom(substepMotions_[largest], substepMotions_[slot], farLimit())) {
            deviates_[slot] = 1;
            deviating_.push_back(slot);
            if (deviating_.size() == farSlots_.size()) {
                return false;
            }
        }
    }
    return true;
}

void Box2dEngine::reportIfStale(b2Contact* contact, SlotIndex slot, SlotIndex other) {
    bool const stopped = movedFar_[slot] == Moved::stopped || movedFar_[other] == Moved::stopped;
    if (!stopped && outOfReach(substepMotions_[slot], substepMotions_[other])) {
        return;
    }
    if ((stopped || movedFarApart(substepMotions_[slot], substepMotions_[other], farLimit())) &&
        isStale(contact)) {
        TouchChange const change = changeOf(contact, contact->IsTouching() ? -1 : 1);
        reported_.push_back({contact, change, slot, other});
        touches_.push_back(change);
    }
}

void Box2dEngine::reportStaleTouches() {
    noteSubstepMotions();
    bool const few = findDeviating();
    // The bodies' lists of contacts side by side, not one after the other: memory then fetches the next
    // contacts of many lists at once.
    edges_.clear();
    for (SlotIndex const slot : few ? deviating_ : farSlots_) {
        if (b2ContactEdge* const edge = bodies_[slot].body->GetContactList(); edge != nullptr) {
            edges_.push_back({edge, slot});
        }
    }
    while (!edges_.empty()) {
        std::size_t kept = 0;
        for (auto const& [edge, slot] : edges_) {
            SlotIndex const other = slotOf(edge->other);
            bool const moved = movedFar_[slot] != Moved::little || movedFar_[other] != Moved::little;
            bool const fromOther = few ? deviates_[other] != 0 : movedFar_[other] != Moved::little;
            if (moved && !(fromOther && other < slot)) { // each pair once
                reportIfStale(edge->contact, slot, other);
            }
            if (b2ContactEdge* const next = edge->next; next != nullptr) {
                __builtin_prefetch(next);
                edges_[kept++] = {next, slot};
            }
        }
        edges_.resize(kept);
    }
}

bool Box2dEngine::takeReported(b2Contact const* contact, TouchChange const& change) {
    auto const known = std::find_if(reported_.begin(), reported_.end(), [&](Reported const& reported) {
        return reported.contact == contact && reported.change.a == change.a && reported.change.b == change.b;
    });
    if (known == reported_.end()) {
        return false;
    }
    reported_.erase(known);
    return true;
}

void Box2dEngine::settleReported() {
    for (Reported const& reported : reported_) { // a body has been moved between the frames
        takeBack(reported);
    }
    reported_.clear();
}

void Box2dEngine::forgetReported(SlotIndex slot) {
    std::erase_if(reported_, [&](Reported const& reported) {
        bool const goes = reported.slot == slot || reported.other == slot;
        if (goes) {
            takeBack(reported);
        }
        return goes;
    });
}

void Box2dEngine::takeBack(Reported const& reported) {
    touches_.push_back({reported.change.a, reported.change.b, -reported.change.delta});
}

std::optional<b2Manifold> Box2dEngine::manifoldNow(b2Contact* contact) const {
    auto const known = std::find_if(reported_.begin(), reported_.end(),
                                    [&](Reported const& reported) { return reported.contact == contact; });
    if (known == reported_.end()) {
        return contact->IsTouching() ? std::optional(*contact->GetManifold()) : std::nullopt;
    }
    if (known->change.delta < 0) {
        return std::nullopt;
    }
    b2Manifold now; // without impulses, as the contact was not solved yet
    contact->Evaluate(&now, contact->GetFixtureA()->GetBody()->GetTransform(),
                      contact->GetFixtureB()->GetBody()->GetTransform());
    for (b2ManifoldPoint& point : now.points) {
        point.normalImpulse = point.tangentImpulse = 0;
    }
    return now;
}

} // namespace trembler
