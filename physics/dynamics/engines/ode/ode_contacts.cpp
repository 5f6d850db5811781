// Contacts in ODE's world, found by Box2D's collision routines, and their contact forces.
#ifdef TREMBLER_HAS_ODE
#include "physics/dynamics/engines/ode/ode_engine.hpp"

#include <algorithm>
#include <utility>

namespace trembler {
namespace {

constexpr double contactCorrection = 0.2; // share of an overlap that is corrected in one substep
constexpr int mostPressing = 12;

// The contact with its objects in the order that ContactPatch requires.
PieceContact inOrderOfObjects(PieceContact contact) {
    if (contact.patch.b < contact.patch.a) {
        std::swap(contact.patch.a, contact.patch.b);
        std::swap(contact.slotA, contact.slotB);
        contact.patch.normal = -contact.patch.normal;
    }
    return contact;
}

} // namespace

bool OdeEngine::mayTouch(SlotIndex a, SlotIndex b) const {
    return (moves(a) || moves(b)) && canHit(bodies()[a].groups, bodies()[b].groups) &&
           (apart_.empty() || !apart_.contains({a, b}));
}

void OdeEngine::findTouches() {
    touches_.clear();
    std::vector<SlotIndex> asked;
    std::vector<std::uint8_t> done(motions_.size(), 0);
    for (;;) {
        // A body that is woken by a contact may touch, and wake, others.
        asked.clear();
        for (SlotIndex slot = 0; slot < motions_.size(); ++slot) {
            if (done[slot] == 0 && moves(slot) && isAwake(slot)) {
                asked.push_back(slot);
                done[slot] = 1;
            }
        }
        if (asked.empty()) {
            break;
        }
        std::size_t const before = touches_.size();
        finder_.find(
            asked, [this](SlotIndex a, SlotIndex b) { return mayTouch(a, b); }, touches_);
        for (std::size_t i = before; i < touches_.size(); ++i) {
            rouseSleeper(touches_[i].a);
            rouseSleeper(touches_[i].b);
        }
    }
    std::sort(touches_.begin(), touches_.end(),
              [](FoundTouch const& x, FoundTouch const& y) { return x.key < y.key; });
    touches_.erase(std::unique(touches_.begin(), touches_.end(),
                               [](FoundTouch const& x, FoundTouch const& y) { return x.key == y.key; }),
                   touches_.end());
    awakeSlots_.clear();
    for (SlotIndex slot = 0; slot < motions_.size(); ++slot) {
        if (done[slot] != 0) {
            awakeSlots_.push_back(slot);
        }
    }
}

// Each of n bodies in one place touches all others, and ODE's time grows with its rows. Contacts between two
// bodies that each have this many others are not given to ODE, so their total is at most this many per body.
void OdeEngine::choosePressing() {
    std::vector<int> others(motions_.size(), 0); // number of movable bodies touched, by slot
    pressing_.assign(touches_.size(), 1);
    for (std::size_t i = 0; i < touches_.size(); ++i) {
        SlotIndex const a = touches_[i].a;
        SlotIndex const b = touches_[i].b;
        if (moves(a) && moves(b)) {
            pressing_[i] = others[a] < mostPressing || others[b] < mostPressing ? 1 : 0;
            others[a] += pressing_[i];
            others[b] += pressing_[i];
        }
    }
}

void OdeEngine::addContacts(double h) {
    choosePressing();
    feedback_.assign(touches_.size(), {});
    for (std::size_t i = 0; i < touches_.size(); ++i) {
        FoundTouch const& touch = touches_[i];
        if (pressing_[i] == 0) {
            continue;
        }
        bool const flipped = idOf(touch.a) == nullptr; // ODE's first body must be movable
        dContact contact{};
        contact.surface.mode = dContactMu2 | dContactFDir1 | dContactApprox1 | dContactSoftERP;
        contact.surface.soft_erp = contactCorrection;
        contact.surface.mu = frictionOf(touch.a, touch.b);
        contact.surface.mu2 = 0; // no friction perpendicular to the plane
        double const bounce = restitutionOf(touch.a, touch.b);
        if (bounce > 0) {
            contact.surface.mode |= dContactBounce;
            contact.surface.bounce = bounce;
            contact.surface.bounce_vel = bounceThreshold(touch.a, touch.b, h);
        }
        Vec2 const inward = flipped ? touch.normal : -touch.normal; // towards ODE's first body
        contact.geom.normal[0] = inward.x;
        contact.geom.normal[1] = inward.y;
        contact.fdir1[0] = -inward.y;
        contact.fdir1[1] = inward.x;
        for (std::size_t n = 0; n < static_cast<std::size_t>(touch.count); ++n) {
            contact.geom.pos[0] = touch.points[n].x;
            contact.geom.pos[1] = touch.points[n].y;
            contact.geom.depth = std::max(touch.depth[n], 0.0);
            dJointID const joint = dJointCreateContact(world_.get(), contacts_.get(), &contact);
            dJointAttach(joint, idOf(flipped ? touch.b : touch.a), idOf(flipped ? touch.a : touch.b));
            dJointSetFeedback(joint, &feedback_[i][n]);
        }
    }
}

PieceContact OdeEngine::contactOf(FoundTouch const& touch) const {
    PieceContact contact{};
    contact.key = touch.key;
    contact.slotA = touch.a;
    contact.slotB = touch.b;
    contact.patch.a = bodies()[touch.a].object;
    contact.patch.b = bodies()[touch.b].object;
    contact.patch.normal = touch.normal;
    contact.patch.points = touch.points;
    contact.patch.count = touch.count;
    return contact;
}

void OdeEngine::reportContacts(double h, std::vector<PieceContact>& found) const {
    for (std::size_t i = 0; i < touches_.size(); ++i) {
        FoundTouch const& touch = touches_[i];
        bool const flipped = idOf(touch.a) == nullptr;
        PieceContact contact = contactOf(touch);
        ContactPatch& patch = contact.patch;
        for (std::size_t n = 0; n < static_cast<std::size_t>(touch.count); ++n) {
            dReal const* const onFirst = feedback_[i][n].f1;
            Vec2 const onB = (flipped ? h : -h) * Vec2{onFirst[0], onFirst[1]};
            patch.normalImpulse[n] = std::max(dot(onB, touch.normal), 0.0);
            // Along the normal turned clockwise.
            patch.tangentImpulse[n] = dot(onB, -perpendicular(touch.normal));
        }
        found.push_back(inOrderOfObjects(contact));
    }
}

bool OdeEngine::lookAgain(std::span<SlotIndex const> fast, std::vector<PieceContact>& found) {
    std::vector<FoundTouch> touches;
    finder_.find(
        fast, [this](SlotIndex a, SlotIndex b) { return mayTouch(a, b); }, touches);
    for (FoundTouch const& touch : touches) {
        found.push_back(inOrderOfObjects(contactOf(touch)));
    }
    return true;
}

} // namespace trembler
#endif
