// What touches at the end of a frame, where Box2D does not know it yet.
//
// Box2D looks at a contact where a substep begins, and at some where bodies are on their way through it. What
// is jammed is thrown about by its correction of overlaps, by some hundredths of a metre in a substep; what
// is fast goes as far by itself. So contacts of two bodies of which one has moved far, as seen by the other,
// are looked at again where they are, and what differs is reported as begun or ended. Box2D itself comes to
// the same result when it next looks, at the beginning of the next substep, and its word for it is then no
// news. Its own state is left as it is: a step without time would find the same, but it changes what Box2D
// starts the next step from, and looks at all contacts instead of a few.
#include "physics/dynamics/engines/box2d/box2d_engine.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {

// As Box2D itself decides whether it looks at a contact, and whether that touches.
bool Box2dEngine::isStale(b2Contact* contact) {
    b2Body const* const a = contact->GetFixtureA()->GetBody();
    b2Body const* const b = contact->GetFixtureB()->GetBody();
    if (!isActive(*a) && !isActive(*b)) {
        return false;
    }
    b2Manifold now;
    contact->Evaluate(&now, a->GetTransform(), b->GetTransform());
    return (now.pointCount > 0) != contact->IsTouching();
}

Box2dEngine::Way Box2dEngine::wayFrom(SlotIndex slot, Place const& start) const {
    b2Body const& body = *bodies_[slot].body;
    return {start.centre, body.GetPosition() - start.centre, body.GetAngle() - start.angle,
            static_cast<float>(bodies_[slot].extent * scale_)};
}

bool Box2dEngine::isFar(Way const& way) const {
    return way.by.Length() + std::abs(way.turn) * way.extent > static_cast<float>(farInSubstep * scale_);
}

bool Box2dEngine::isFarApart(Way const& a, Way const& b) const {
    if (a.extent < b.extent) {
        return isFarApart(b, a); // the points of the smaller one have moved less
    }
    bool const little = std::abs(a.turn) < 0.1F; // nearly all are: the series are exact to 2e-4 of a distance
    b2Rot turned;
    turned.s = little ? a.turn : std::sin(a.turn);
    turned.c = little ? 1 - a.turn * a.turn / 2 : std::cos(a.turn);
    b2Vec2 const before = b.from - a.from;
    b2Vec2 const now = before + b.by - a.by;
    return isFar({{}, now - b2Mul(turned, before), b.turn - a.turn, b.extent});
}

// By their places, not by their speeds: what is jammed moves without a speed, and may even be thrown back to
// where it began the substep.
void Box2dEngine::reportStaleTouches() {
    ways_.resize(bodies_.size());
    movedFar_.assign(bodies_.size(), Moved::little);
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (bodies_[slot].body != nullptr) {
            ways_[slot] = wayFrom(slot, start_[slot]);
            if (awake_[slot] != 0 && isFar(ways_[slot])) {
                movedFar_[slot] = Moved::far;
            }
        }
    }
    for (OnTheWay const& change : changedOnTheWay_) {
        if (change.ended || isFar(wayFrom(change.slot, change.place))) {
            movedFar_[change.slot] = Moved::stopped;
        }
    }
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (movedFar_[slot] == Moved::little) {
            continue;
        }
        for (b2ContactEdge* edge = bodies_[slot].body->GetContactList(); edge != nullptr; edge = edge->next) {
            SlotIndex const other = slotOf(edge->other);
            bool const seen = other < slot && movedFar_[other] != Moved::little; // from its other end
            bool const stopped = movedFar_[slot] == Moved::stopped || movedFar_[other] == Moved::stopped;
            if (!seen && (stopped || isFarApart(ways_[slot], ways_[other])) && isStale(edge->contact)) {
                TouchChange const change = changeOf(edge->contact, edge->contact->IsTouching() ? -1 : 1);
                reported_.push_back({edge->contact, change, slot, other});
                touches_.push_back(change);
            }
        }
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
    for (Reported const& reported : reported_) { // something has moved between the frames
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
    b2Manifold now; // without impulses: nothing has pressed there yet
    contact->Evaluate(&now, contact->GetFixtureA()->GetBody()->GetTransform(),
                      contact->GetFixtureB()->GetBody()->GetTransform());
    for (b2ManifoldPoint& point : now.points) {
        point.normalImpulse = point.tangentImpulse = 0;
    }
    return now;
}

} // namespace trembler
