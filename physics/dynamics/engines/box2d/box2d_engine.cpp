#include "physics/dynamics/engines/box2d/box2d_engine.hpp"

#include "physics/dynamics/engines/box2d/box2d_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler {
namespace {

constexpr std::uintptr_t groundData = ~std::uintptr_t{0};
// Limit of removals times waiting bodies: some thousandths of a second.
constexpr double mostLooksAtAdded = 4e6;

} // namespace

Box2dEngine::Box2dEngine(double scale) : scale_(scale), world_(b2Vec2_zero) {
    world_.SetAutoClearForces(false); // loads act in all substeps
    world_.SetContactListener(this);
    world_.SetContactFilter(&crowds_);
    b2BodyDef def;
    def.userData.pointer = groundData;
    ground_ = world_.CreateBody(&def);
}

Box2dEngine::~Box2dEngine() {
    world_.SetContactListener(nullptr);
}

SlotIndex Box2dEngine::slotOf(b2Body const* body) const {
    // GetUserData() is const only since Box2D 2.4.2.
    std::uintptr_t const data = const_cast<b2Body*>(body)->GetUserData().pointer;
    return data == groundData ? noSlot : static_cast<SlotIndex>(data);
}

void Box2dEngine::addBody(SlotIndex slot, BodySpec const& spec) {
    if (bodies_.size() <= slot) {
        bodies_.resize(slot + std::size_t{1});
        awake_.resize(slot + std::size_t{1}, 0);
        movedMarks_.resize(slot + std::size_t{1}, 0);
    }
    b2BodyDef def;
    def.type = spec.fixed ? b2_staticBody : b2_dynamicBody;
    def.position = toEngine(spec.motion.centre);
    def.angle = static_cast<float>(spec.motion.angle);
    if (!spec.fixed) {
        def.linearVelocity = toEngine(spec.motion.velocity);
        def.angularVelocity = static_cast<float>(spec.motion.spin);
        def.linearDamping = static_cast<float>(spec.damping.linear);
        def.angularDamping = static_cast<float>(spec.damping.angular);
        def.bullet = spec.bullet;
    }
    def.userData.pointer = slot;
    b2Body* const body = world_.CreateBody(&def);
    ++added_;
    bodies_[slot] = {.body = body,
                     .object = spec.object,
                     .force = b2Vec2_zero,
                     .torque = 0,
                     .restlessJoints = 0,
                     .core = coreOf(spec),
                     .extent = extentOf(spec)};
    b2FixtureDef fixture; // its density stays 0: mass and moment are set for the whole body
    if (stops(*body)) {
        stopping_.insert(slot);
    }
    fixture.friction = static_cast<float>(spec.friction);
    fixture.restitution = static_cast<float>(spec.restitution);
    fixture.filter.categoryBits = static_cast<std::uint16_t>(spec.groups.category);
    fixture.filter.maskBits = static_cast<std::uint16_t>(spec.groups.mask);
    fixture.filter.groupIndex = static_cast<std::int16_t>(spec.groups.group);
    makeShapes(spec, scale_, [&](b2Shape const& shape) {
        fixture.shape = &shape;
        body->CreateFixture(&fixture);
    });
    if (!spec.fixed) {
        b2MassData mass;
        mass.mass = static_cast<float>(spec.mass);
        mass.center = b2Vec2_zero;
        mass.I = static_cast<float>(spec.mass * spec.spread.inertiaPerMass * scale_ * scale_);
        body->SetMassData(&mass);
        awake_[slot] = 1;
        anyAwake_ = true;
    }
}

void Box2dEngine::findContactsOfAdded() {
    added_ = 0;
    removed_ = 0;
    // Creates contacts, but reports no touches. Box2D has no other access to this outside of a step.
    guardBox2d([&] { const_cast<b2ContactManager&>(world_.GetContactManager()).FindNewContacts(); });
}

void Box2dEngine::removeBody(SlotIndex slot) {
    // Box2D keeps a list of added bodies whose contacts it has not searched for, and each removal walks it.
    if (added_ > 0 && static_cast<double>(++removed_) * added_ > mostLooksAtAdded) {
        findContactsOfAdded();
    }
    world_.DestroyBody(bodies_[slot].body);
    forgetReported(slot);
    stopping_.erase(slot);
    bodies_[slot] = {};
    awake_[slot] = 0;
    disturbed_ = true; // Box2D has woken the bodies that touched it
    if (slot < dragged_.size()) {
        dragged_[slot] = {};
    }
}

void Box2dEngine::place(SlotIndex slot, Motion const& motion) {
    b2Body& body = *bodies_[slot].body;
    body.SetTransform(toEngine(motion.centre), static_cast<float>(motion.angle));
    body.SetLinearVelocity(toEngine(motion.velocity));
    body.SetAngularVelocity(static_cast<float>(motion.spin));
    for (b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
        wakeAll(edge->other);
    }
    wakeAll(&body);
}

bool Box2dEngine::isAt(SlotIndex slot, Motion const& motion) const {
    b2Body const& body = *bodies_[slot].body;
    if (!(body.GetPosition() == toEngine(motion.centre)) ||
        body.GetAngle() != static_cast<float>(motion.angle)) {
        return false;
    }
    return body.GetType() == b2_staticBody || (body.GetLinearVelocity() == toEngine(motion.velocity) &&
                                               body.GetAngularVelocity() == static_cast<float>(motion.spin));
}

void Box2dEngine::applyImpulse(SlotIndex slot, Vec2 impulse, Vec2 point) {
    wake(slot);
    b2Body& body = *bodies_[slot].body;
    double const limit = maximumSpeed * static_cast<double>(body.GetMass());
    double const size = std::hypot(impulse.x, impulse.y);
    if (size > limit) {
        impulse *= limit / size;
    }
    // Far from the body's centre only the change of spin matters, and that is limited below.
    double const reach = maximumDistance;
    point = {std::clamp(point.x, -reach, reach), std::clamp(point.y, -reach, reach)};
    body.ApplyLinearImpulse(toEngine(impulse), toEngine(point), true);
    float const spin = static_cast<float>(maximumSpeed);
    body.SetAngularVelocity(b2Clamp(body.GetAngularVelocity(), -spin, spin));
}

bool Box2dEngine::solveJointsAtOnce(bool wanted) {
    if (wanted != (atOnce_ != nullptr)) {
        atOnce_ = wanted ? std::make_unique<JointsAtOnce>() : nullptr;
        tiesStale_ = wanted;
        coldStart_ = wanted;
    }
    return wanted;
}

void Box2dEngine::applyJoints(float substep) {
    if (!atOnce_) {
        return;
    }
    if (std::exchange(tiesStale_, false)) {
        std::vector<b2Joint*> joints;
        for (JointEntry const& entry : joints_) {
            joints.push_back(entry.joint);
        }
        atOnce_->setJoints(joints);
    }
    atOnce_->solve(substep, [this](b2Body const& body) {
        BodyEntry const& entry = bodies_[slotOf(&body)];
        return JointsAtOnce::Pull{entry.force, entry.torque};
    });
    // In the first step after JointsAtOnce was enabled, Box2D's impulses of the last step would carry the
    // same loads a second time.
    world_.SetWarmStarting(!std::exchange(coldStart_, false));
}

void Box2dEngine::step(double duration, DynamicsSettings const& settings) {
    if (world_.GetAllowSleeping() != settings.sleeping) {
        world_.SetAllowSleeping(settings.sleeping);
        disturbed_ = true;
    }
    loadWoken();
    movedCount_ = 0;
    for (JointEntry& entry : joints_) {
        entry.force = {};
    }
    impacts_.clear();
    float const h = static_cast<float>(duration / settings.substeps);
    substep_ = h;
    for (int substep = 0; substep < settings.substeps; ++substep) {
        since_ = duration * substep / settings.substeps;
        noteVelocities();
        applyDrags(static_cast<double>(h));
        applyJoints(h);
        bool const last = substep + 1 == settings.substeps;
        takeStep(h, settings, last);
        settleImpacts();
        noteDragged();
        anyAwake_ = false;
        if (last) {
            noteMotion(settings.sleeping);
        } else {
            noteSubstep();
        }
        for (SlotIndex slot = 0; slot < joints_.size(); ++slot) {
            JointEntry& entry = joints_[slot];
            if (entry.joint != nullptr) {
                b2Vec2 const before = atOnce_ ? (1 / h) * atOnce_->impulse(slot) : b2Vec2_zero;
                entry.force += fromEngine(entry.joint->GetReactionForce(1 / h) + before) / settings.substeps;
            }
        }
    }
}

// Box2D has just searched for contacts, so its data of the bodies are no longer in the nearest cache.
void Box2dEngine::prefetchAfter(SlotIndex slot, BodyEntry const* entries, SlotIndex count) {
    constexpr SlotIndex ahead = 8;
    if (slot + ahead < count && entries[slot + ahead].body != nullptr) {
        auto const* const body = reinterpret_cast<char const*>(entries[slot + ahead].body);
        __builtin_prefetch(body);
        __builtin_prefetch(body + 64);
    }
}

void Box2dEngine::noteAwake(SlotIndex slot, bool mayFallAsleep) {
    BodyEntry& entry = bodies_[slot];
    if (!entry.body->IsAwake()) {
        awake_[slot] = 0;
        return;
    }
    anyAwake_ = true;
    if (mayFallAsleep && drifts(entry)) {
        entry.body->SetAwake(true); // resets its sleep timer
    }
}

void Box2dEngine::noteSubstep() {
    auto const count = static_cast<SlotIndex>(bodies_.size());
    for (SlotIndex slot = 0; slot < count; ++slot) {
        prefetchAfter(slot, bodies_.data(), count);
        if (awake_[slot] != 0) {
            movedMarks_[slot] = 1;
            noteAwake(slot, false);
        }
    }
}

// The pointers are local, because the compiler must assume that a mark of one byte changes any member.
void Box2dEngine::noteMotion(bool sleeping) {
    moved_.resize(std::max(moved_.size(), bodies_.size()));
    MovedBody* next = moved_.data();
    BodyEntry const* const entries = bodies_.data();
    std::uint8_t const* const awake = awake_.data();
    std::uint8_t* const marks = movedMarks_.data();
    auto const count = static_cast<SlotIndex>(bodies_.size());
    for (SlotIndex slot = 0; slot < count; ++slot) {
        prefetchAfter(slot, entries, count);
        bool const was = awake[slot] != 0;
        if (!was && marks[slot] == 0) {
            continue;
        }
        marks[slot] = 0;
        if (was) {
            noteAwake(slot, sleeping);
        }
        b2Body const& body = *entries[slot].body;
        next->slot = slot;
        next->motion = {fromEngine(body.GetPosition()), static_cast<double>(body.GetAngle()),
                        fromEngine(body.GetLinearVelocity()), static_cast<double>(body.GetAngularVelocity())};
        ++next;
    }
    movedCount_ = static_cast<std::size_t>(next - moved_.data());
}

std::vector<SlotIndex> Box2dEngine::lost() const {
    std::vector<SlotIndex> found;
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        b2Body const* const body = bodies_[slot].body;
        if (body != nullptr &&
            !(body->GetPosition().IsValid() && b2IsValid(body->GetAngle()) &&
              body->GetLinearVelocity().IsValid() && b2IsValid(body->GetAngularVelocity()))) {
            found.push_back(slot);
        }
    }
    return found;
}

std::unique_ptr<Engine> makeBox2dEngine(double scale) {
    return std::make_unique<Box2dEngine>(scale);
}

} // namespace trembler
