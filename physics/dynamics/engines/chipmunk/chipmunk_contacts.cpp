// Contacts, as reported by Chipmunk during its step.
#ifdef TREMBLER_HAS_CHIPMUNK
#include "physics/dynamics/engines/chipmunk/chipmunk_engine.hpp"

#include <algorithm>
#include <chipmunk/chipmunk_structs.h>
#include <utility>

namespace trembler {
namespace {

SlotIndex slotOf(cpShape const* shape) {
    return slotOfPiece(pieceOf(shape));
}

cpVect velocityAt(cpBody const& body, cpVect arm) {
    return cpvadd(body.v, cpvmult(cpvperp(arm), body.w));
}

} // namespace

cpBool ChipmunkEngine::beginTouch(cpArbiter* arbiter, cpSpace* /*space*/, cpDataPointer self) {
    auto const& engine = *static_cast<ChipmunkEngine const*>(self);
    return canHit(engine.bodies()[slotOf(arbiter->a)].groups, engine.bodies()[slotOf(arbiter->b)].groups)
               ? cpTrue
               : cpFalse;
}

cpBool ChipmunkEngine::beforeSolving(cpArbiter* arbiter, cpSpace* /*space*/, cpDataPointer self) {
    auto const& engine = *static_cast<ChipmunkEngine const*>(self);
    SlotIndex const a = slotOf(arbiter->a);
    SlotIndex const b = slotOf(arbiter->b);
    arbiter->u = engine.frictionOf(a, b);
    arbiter->e = engine.restitutionOf(a, b);
    if (arbiter->e > 0) {
        double approach = 0;
        for (int i = 0; i < arbiter->count; ++i) {
            cpContact const& contact = arbiter->contacts[i];
            cpVect const relative =
                cpvsub(velocityAt(*arbiter->body_b, contact.r2), velocityAt(*arbiter->body_a, contact.r1));
            approach = std::max(approach, -cpvdot(relative, arbiter->n));
        }
        if (approach < engine.bounceThreshold(a, b, engine.h_)) {
            arbiter->e = 0;
        }
    }
    return cpTrue;
}

void ChipmunkEngine::afterSolving(cpArbiter* arbiter, cpSpace* /*space*/, cpDataPointer self) {
    static_cast<ChipmunkEngine*>(self)->noteContact(*arbiter);
}

void ChipmunkEngine::noteContact(cpArbiter const& arbiter) {
    std::uint32_t const pieceA = pieceOf(arbiter.a);
    std::uint32_t const pieceB = pieceOf(arbiter.b);
    PieceContact contact;
    contact.key = pieceKey(pieceA, pieceB);
    contact.slotA = slotOfPiece(pieceA);
    contact.slotB = slotOfPiece(pieceB);
    ContactPatch& patch = contact.patch;
    patch.a = bodies()[contact.slotA].object;
    patch.b = bodies()[contact.slotB].object;
    patch.normal = {arbiter.n.x, arbiter.n.y};
    patch.count = std::min(arbiter.count, 2);
    for (std::size_t i = 0; i < static_cast<std::size_t>(patch.count); ++i) {
        cpContact const& point = arbiter.contacts[i];
        cpVect const middle =
            cpvlerp(cpvadd(arbiter.body_a->p, point.r1), cpvadd(arbiter.body_b->p, point.r2), 0.5);
        patch.points[i] = {middle.x, middle.y};
        patch.normalImpulse[i] = point.jnAcc;
        patch.tangentImpulse[i] = -point.jtAcc; // along the normal turned clockwise, as in Box2D
    }
    if (patch.b < patch.a) {
        std::swap(patch.a, patch.b);
        std::swap(contact.slotA, contact.slotB);
        patch.normal = -patch.normal;
    }
    found_->push_back(contact);
}

} // namespace trembler
#endif
