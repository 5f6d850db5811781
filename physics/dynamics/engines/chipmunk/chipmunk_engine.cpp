#ifdef TREMBLER_HAS_CHIPMUNK
#include "physics/dynamics/engines/chipmunk/chipmunk_engine.hpp"

#include "physics/dynamics/engines/chipmunk/chipmunk_dynamics.hpp"
#include "physics/dynamics/engines/chipmunk/chipmunk_joint.hpp"

#include <algorithm>
#include <chipmunk/chipmunk_structs.h>
#include <cmath>

namespace trembler {

ChipmunkEngine::ChipmunkEngine() : space_(newSpaceQuietly()) {
    cpSpaceSetGravity(space_.get(), cpvzero); // gravity is a force like others
    cpSpaceSetCollisionSlop(space_.get(), skinDepth);
    // Bodies sleep only when this engine puts them to sleep, but Chipmunk needs sleeping to be enabled.
    cpSpaceSetSleepTimeThreshold(space_.get(), 1e30);
    cpCollisionHandler* const handler = cpSpaceAddDefaultCollisionHandler(space_.get());
    handler->userData = this;
    handler->beginFunc = beginTouch;
    handler->preSolveFunc = beforeSolving;
    handler->postSolveFunc = afterSolving;
}

ChipmunkEngine::~ChipmunkEngine() {
    for (SlotIndex slot = 0; slot < joints_.size(); ++slot) {
        if (joints_[slot]) {
            dropJoint(slot);
        }
    }
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (bodies_[slot] != nullptr) {
            dropBody(slot);
        }
    }
}

void ChipmunkEngine::makeBody(SlotIndex slot, BodySpec const& spec) {
    if (bodies_.size() <= slot) {
        bodies_.resize(slot + std::size_t{1}, nullptr);
        places_.resize(slot + std::size_t{1});
    }
    cpBody* const body =
        spec.fixed ? cpBodyNewStatic() : cpBodyNew(spec.mass, spec.mass * spec.spread.inertiaPerMass);
    bodies_[slot] = body;
    places_[slot] = std::make_unique<Place>(Place{this, slot});
    cpBodySetUserData(body, places_[slot].get());
    cpSpaceAddBody(space_.get(), body);
    setMotion(slot, spec.motion);
    if (!spec.fixed) {
        cpBodySetVelocityUpdateFunc(body, updateVelocity);
        cpBodySetPositionUpdateFunc(body, updatePosition);
    }
    addShapes(*space_, *body, slot, spec);
}

void ChipmunkEngine::dropBody(SlotIndex slot) {
    cpBody* const body = bodies_[slot];
    while (body->shapeList != nullptr) {
        cpShape* const shape = body->shapeList;
        cpSpaceRemoveShape(space_.get(), shape);
        cpShapeFree(shape);
    }
    cpSpaceRemoveBody(space_.get(), body);
    cpBodyFree(body);
    bodies_[slot] = nullptr;
}

Motion ChipmunkEngine::motionOf(SlotIndex slot) const {
    cpBody const& body = *bodies_[slot];
    return {{body.p.x, body.p.y}, body.a, {body.v.x, body.v.y}, body.w};
}

void ChipmunkEngine::setMotion(SlotIndex slot, Motion const& motion) {
    cpBody* const body = bodies_[slot];
    cpBodySetPosition(body, cpv(motion.centre.x, motion.centre.y));
    cpBodySetAngle(body, motion.angle);
    if (moves(slot)) {
        cpBodySetVelocity(body, cpv(motion.velocity.x, motion.velocity.y));
        cpBodySetAngularVelocity(body, motion.spin);
        body->v_bias = cpvzero;
        body->w_bias = 0;
    }
    cpSpaceReindexShapesForBody(space_.get(), body);
}

void ChipmunkEngine::rouse(SlotIndex slot) {
    cpBodyActivate(bodies_[slot]);
}

void ChipmunkEngine::layToRest(std::span<SlotIndex const> island) {
    cpBody* const first = bodies_[island.front()];
    for (SlotIndex const slot : island) {
        bodies_[slot]->v_bias = cpvzero;
        bodies_[slot]->w_bias = 0;
        cpBodySleepWithGroup(bodies_[slot], slot == island.front() ? nullptr : first);
    }
}

void ChipmunkEngine::move(double h, DynamicsSettings const& settings, std::vector<PieceContact>& found) {
    // Each substep corrects a fifth of the overlap of skins, whatever the substep's length.
    cpSpaceSetCollisionBias(space_.get(), std::pow(0.8, 1 / h));
    cpSpaceSetIterations(space_.get(), settings.velocityIterations);
    h_ = h;
    found_ = &found;
    cpSpaceStep(space_.get(), h);
    found_ = nullptr;
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (moves(slot) && isAwake(slot)) {
            limitSpeed(*bodies_[slot]);
        }
    }
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (moves(slot) && !isAwake(slot) && cpBodyIsSleeping(bodies_[slot]) == cpFalse) {
            noteAwake(slot);
        }
    }
}

// Joints and contacts may have caused any speed.
void ChipmunkEngine::limitSpeed(cpBody& body) {
    double const speed = cpvlength(body.v);
    if (speed > maximumSpeed) {
        body.v = cpvmult(body.v, maximumSpeed / speed);
    }
    body.w = std::clamp(body.w, -maximumSpeed, maximumSpeed);
}

void ChipmunkEngine::updateVelocity(cpBody* body, cpVect /*gravity*/, cpFloat /*damping*/, cpFloat h) {
    Place const& place = *static_cast<Place const*>(body->userData);
    Motion motion = place.engine->motionOf(place.slot);
    place.engine->accelerate(place.slot, motion, h);
    body->v = cpv(motion.velocity.x, motion.velocity.y);
    body->w = motion.spin;
}

void ChipmunkEngine::updatePosition(cpBody* body, cpFloat h) {
    Place const& place = *static_cast<Place const*>(body->userData);
    double const share = place.engine->freeShare(body, place.slot, h);
    if (share >= 1) {
        cpBodyUpdatePosition(body, h);
        return;
    }
    cpVect const velocity = body->v;
    body->v = cpvmult(velocity, share);
    body->v_bias = cpvzero;
    cpBodyUpdatePosition(body, h);
    body->v = velocity;
}

double ChipmunkEngine::freeShare(cpBody const* body, SlotIndex slot, double h) const {
    BodyEntry const& entry = bodies()[slot];
    cpVect const way = cpvmult(body->v, h);
    if (cpvlength(way) <= entry.core.reach()) {
        return 1;
    }
    Vec2 const core = rotated(entry.core.at, body->a);
    cpVect const start = cpvadd(body->p, cpv(core.x, core.y));
    struct Search {
        ChipmunkEngine const& engine;
        BodyEntry const& entry;
        SlotIndex slot;
        double share = 1;
    } search{*this, entry, slot};
    cpSpaceSegmentQuery(
        space_.get(), start, cpvadd(start, way), entry.core.radius, CP_SHAPE_FILTER_ALL,
        [](cpShape* shape, cpVect /*point*/, cpVect /*normal*/, cpFloat alpha, void* data) {
            Search& found = *static_cast<Search*>(data);
            SlotIndex const other = slotOfPiece(pieceOf(shape));
            BodyEntry const& hit = found.engine.bodies()[other];
            if (other != found.slot && (hit.fixed || found.entry.bullet) &&
                canHit(found.entry.groups, hit.groups)) {
                found.share = std::min(found.share, alpha);
            }
        },
        &search);
    return search.share;
}

std::unique_ptr<Engine> makeChipmunkEngine(double /*scale*/) {
    return std::make_unique<ChipmunkEngine>();
}

} // namespace trembler
#endif
