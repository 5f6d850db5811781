// One substep of Box2D, and continuous collision detection for bodies that are so fast that they could jump
// through others.
//
// Box2D finds the first impact within a substep, goes back to it, and searches all contacts for the next:
// this costs impacts times contacts, too much if thousands of bodies land at once, or if wedged bodies spin
// so fast that a frame has hundreds of substeps. In these cases the path of each fast body is tested
// separately, as in the other engines.
#include "physics/dynamics/engines/box2d/box2d_engine.hpp"
#include "runtime/component/component.hpp"

#include <box2d/b2_distance.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler {
namespace {

// Limit of impacts times contacts in a substep: some hundredths of a second.
constexpr double mostLooks = 4e6;
// In a frame of more substeps than this, the limit of contacts with bodies that stop others, summed over its
// substeps. Box2D may find the time of impact of each eight times in a substep, at up to 0.1 ms each.
constexpr double manySubsteps = 32;
constexpr double mostStops = 3000;

bool tiedApart(b2Body* a, b2Body const* b) {
    for (b2JointEdge* edge = a->GetJointList(); edge != nullptr; edge = edge->next) {
        if (edge->other == b && !edge->joint->GetCollideConnected()) {
            return true;
        }
    }
    return false;
}

// Visits the fixtures near a box.
template <class Visitor>
class NearFixtures final : public b2QueryCallback {
public:
    explicit NearFixtures(Visitor visit) : visit_(std::move(visit)) {}
    bool ReportFixture(b2Fixture* fixture) override {
        visit_(*fixture);
        return true;
    }

private:
    Visitor visit_;
};

} // namespace

bool Box2dEngine::tooManyImpacts(double h) const {
    double const contacts = world_.GetContactCount();
    double const substeps = frameDuration / h;
    if (contacts * contacts <= mostLooks && substeps <= manySubsteps) {
        return false;
    }
    // Box2D's continuous collision detection covers static bodies and bullets: counts each such contact once.
    double impacts = 0; // upper bound of the number of impacts, equal in any order of slots
    for (SlotIndex const slot : stopping_.members()) {
        bool const moves = isActive(*bodies_[slot].body);
        for (b2ContactEdge const* edge = bodies_[slot].body->GetContactList(); edge != nullptr;
             edge = edge->next) {
            bool const seen = stops(*edge->other) && slotOf(edge->other) < slot;
            impacts += !seen && (moves || isActive(*edge->other)) ? 1 : 0;
        }
    }
    return contacts * impacts > mostLooks || (substeps > manySubsteps && impacts * substeps > mostStops);
}

void Box2dEngine::noteStart() {
    start_.resize(bodies_.size());
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        if (bodies_[slot].body != nullptr) { // a sleeping body may be woken within the substep
            start_[slot] = {bodies_[slot].body->GetPosition(), bodies_[slot].body->GetAngle()};
        }
    }
}

void Box2dEngine::takeStep(float h, DynamicsSettings const& settings, bool last) {
    removed_ = 0;
    if (double const added = std::exchange(added_, 0); added * added > mostLooks) {
        // Box2D finds the contacts of new bodies only in a step. A step of zero length does nothing else.
        guardBox2d([&] { world_.Step(0, settings.velocityIterations, settings.positionIterations); });
    }
    bool const many = tooManyImpacts(static_cast<double>(h));
    bool const compares = last && touchesAtEnd_;
    if (many || compares) {
        noteStart();
    }
    world_.SetContinuousPhysics(!many);
    watching_ = compares;
    changedOnTheWay_.clear();
    guardBox2d([&] { world_.Step(h, settings.velocityIterations, settings.positionIterations); });
    watching_ = false;
    settleReported();
    if (many) {
        holdBack();
    }
    if (compares) {
        reportStaleTouches();
    }
}

void Box2dEngine::holdBack() {
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (awake_[slot] == 0 || bodies_[slot].body == nullptr) {
            continue;
        }
        b2Body& body = *bodies_[slot].body;
        b2Vec2 const way = body.GetPosition() - start_[slot].centre;
        if (length(fromEngine(way)) > bodies_[slot].core.reach()) {
            float const share = freeShare(bodies_[slot], start_[slot], way);
            if (share < 1) {
                body.SetTransform(start_[slot].centre + share * way, body.GetAngle());
            }
        }
    }
}

float Box2dEngine::freeShare(BodyEntry const& entry, Place const& start, b2Vec2 way) const {
    b2CircleShape disc;
    disc.m_p = b2Vec2_zero;
    disc.m_radius = static_cast<float>(entry.core.radius * scale_);
    b2Transform at;
    at.Set(start.centre, start.angle);
    at.p = b2Mul(at, toEngine(entry.core.at));
    b2Transform end = at;
    end.p += way;
    b2AABB box;
    b2AABB boxAtEnd;
    disc.ComputeAABB(&box, at, 0);
    disc.ComputeAABB(&boxAtEnd, end, 0);
    box.Combine(boxAtEnd);
    b2Fixture* const own = entry.body->GetFixtureList();
    float share = 1;
    NearFixtures near([&](b2Fixture& fixture) {
        b2Body* const other = fixture.GetBody();
        bool const stops = other->GetType() != b2_dynamicBody || entry.body->IsBullet();
        if (other == entry.body || !stops || !b2ContactFilter{}.ShouldCollide(own, &fixture) ||
            tiedApart(entry.body, other)) {
            return;
        }
        if (fixture.TestPoint(at.p)) {
            return; // b2ShapeCast may report a hit at the beginning of the path
        }
        b2ShapeCastInput input;
        input.proxyA.Set(fixture.GetShape(), 0);
        input.proxyB.Set(&disc, 0);
        input.transformA = other->GetTransform();
        input.transformB = at;
        input.translationB = way;
        b2ShapeCastOutput output;
        if (b2ShapeCast(&output, &input)) {
            share = std::min(share, output.lambda);
        }
    });
    world_.QueryAABB(&near, box);
    return share;
}

} // namespace trembler
