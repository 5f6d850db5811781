#include "physics/dynamics/box2d/box2d_engine.hpp"

#include "physics/dynamics/box2d/box2d_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler {
namespace {

constexpr std::uintptr_t groundData = ~std::uintptr_t{0};

ImpactBook::Key keyOf(b2Contact const* contact) {
    return reinterpret_cast<std::uintptr_t>(contact);
}

// What drifts freely, however slowly, does not come to rest by itself: above these it must not fall asleep.
constexpr double driftAcceleration = 1e-3; // m/s²
constexpr double driftSpeed = 1e-4;        // m/s
constexpr double driftSpin = 1e-3;         // rad/s

} // namespace

Box2dEngine::Box2dEngine(double scale) : scale_(scale), world_(b2Vec2_zero) {
    world_.SetAutoClearForces(false); // loads stand for all substeps
    world_.SetContactListener(this);
    b2BodyDef def;
    def.userData.pointer = groundData;
    ground_ = world_.CreateBody(&def);
}

Box2dEngine::~Box2dEngine() {
    world_.SetContactListener(nullptr);
}

SlotIndex Box2dEngine::slotOf(b2Body const* body) const {
    // GetUserData() is const only from 2.4.2 on.
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
    bodies_[slot] = {
        .body = body, .object = spec.object, .force = b2Vec2_zero, .torque = 0, .restlessJoints = 0};
    b2FixtureDef fixture; // whose density stays 0: mass and moment are set for the body as a whole
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

void Box2dEngine::removeBody(SlotIndex slot) {
    world_.DestroyBody(bodies_[slot].body);
    bodies_[slot] = {};
    awake_[slot] = 0;
    disturbed_ = true; // Box2D has woken those that touched it
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

void Box2dEngine::setLoads(std::span<Load const> loads) {
    loadWoken();
    world_.ClearForces();
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        BodyEntry& entry = bodies_[slot];
        if (entry.body == nullptr) {
            continue;
        }
        Load const load = slot < loads.size() ? loads[slot] : Load{};
        entry.force = toEngine(load.force);
        entry.torque = static_cast<float>(load.torque * scale_ * scale_);
        if (awake_[slot] != 0) {
            entry.body->ApplyForceToCenter(entry.force, false);
            entry.body->ApplyTorque(entry.torque, false);
        }
    }
}

void Box2dEngine::setDrags(std::span<Drag const> drags) {
    draggedSlots_.clear();
    dragged_.resize(drags.empty() ? 0 : bodies_.size());
    for (SlotIndex slot = 0; slot < dragged_.size(); ++slot) {
        b2Body const* const body = bodies_[slot].body;
        if (slot < drags.size() && drags[slot].any() && body != nullptr &&
            body->GetType() == b2_dynamicBody) {
            dragged_[slot].drag = drags[slot];
            draggedSlots_.push_back(slot);
        } else {
            dragged_[slot] = {};
        }
    }
}

Twist Box2dEngine::momentumOf(b2Body const& body) const {
    return {static_cast<double>(body.GetMass()) * fromEngine(body.GetLinearVelocity()),
            static_cast<double>(body.GetInertia()) / (scale_ * scale_) *
                static_cast<double>(body.GetAngularVelocity())};
}

void Box2dEngine::applyDrags(double substep) {
    double const square = scale_ * scale_;
    for (SlotIndex const slot : draggedSlots_) {
        BodyEntry const& entry = bodies_[slot];
        if (entry.body == nullptr || awake_[slot] == 0) {
            continue;
        }
        Twist const load{substep * fromEngine(entry.force),
                         substep * static_cast<double>(entry.torque) / square};
        Twist const impulse = dragged_[slot].before(static_cast<double>(entry.body->GetMass()),
                                                    static_cast<double>(entry.body->GetInertia()) / square,
                                                    momentumOf(*entry.body), load, substep);
        entry.body->ApplyLinearImpulseToCenter(toEngine(impulse.linear), false);
        entry.body->ApplyAngularImpulse(static_cast<float>(impulse.angular * square), false);
    }
}

void Box2dEngine::noteDragged() {
    for (SlotIndex const slot : draggedSlots_) {
        if (bodies_[slot].body != nullptr && awake_[slot] != 0) {
            dragged_[slot].after(momentumOf(*bodies_[slot].body));
        }
    }
}

void Box2dEngine::wake(SlotIndex slot) {
    wakeAll(bodies_[slot].body);
}

void Box2dEngine::wakeAll(b2Body* body) {
    wakeStack_.push_back(body);
    while (!wakeStack_.empty()) {
        b2Body& next = *wakeStack_.back();
        wakeStack_.pop_back();
        SlotIndex const slot = slotOf(&next);
        if (next.GetType() != b2_dynamicBody || slot == noSlot || awake_[slot] != 0) {
            continue;
        }
        next.SetAwake(true);
        next.ApplyForceToCenter(bodies_[slot].force, false);
        next.ApplyTorque(bodies_[slot].torque, false);
        awake_[slot] = 1;
        anyAwake_ = true;
        for (b2ContactEdge* edge = next.GetContactList(); edge != nullptr; edge = edge->next) {
            if (edge->contact->IsTouching() && edge->contact->IsEnabled()) {
                wakeStack_.push_back(edge->other);
            }
        }
        for (b2JointEdge* edge = next.GetJointList(); edge != nullptr; edge = edge->next) {
            wakeStack_.push_back(edge->other);
        }
    }
}

// Box2D wakes bodies by itself too: when what they rested on is destroyed, or when sleep is forbidden.
void Box2dEngine::loadWoken() {
    if (!std::exchange(disturbed_, false)) {
        return;
    }
    for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
        b2Body* const body = bodies_[slot].body;
        if (body != nullptr && awake_[slot] == 0 && body->GetType() == b2_dynamicBody && body->IsAwake()) {
            wakeAll(body);
        }
    }
}

void Box2dEngine::keepAwake(SlotIndex slot, int change) {
    BodyEntry& entry = bodies_[slot];
    entry.restlessJoints += change;
    if (entry.body->GetType() == b2_dynamicBody &&
        entry.body->IsSleepingAllowed() != (entry.restlessJoints == 0)) {
        wakeAll(entry.body);
        entry.body->SetSleepingAllowed(entry.restlessJoints == 0);
    }
}

void Box2dEngine::applyImpulse(SlotIndex slot, Vec2 impulse, Vec2 point) {
    wake(slot);
    b2Body& body = *bodies_[slot].body;
    double const limit = maximumSpeed * static_cast<double>(body.GetMass());
    double const size = std::hypot(impulse.x, impulse.y);
    if (size > limit) {
        impulse *= limit / size;
    }
    // Far from the body's centre only its turning counts, and that is limited below.
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
    // Box2D starts from the impulses of its last step, which would carry what is carried already.
    world_.SetWarmStarting(!std::exchange(coldStart_, false));
}

void Box2dEngine::step(double duration, DynamicsSettings const& settings) {
    if (world_.GetAllowSleeping() != settings.sleeping) {
        world_.SetAllowSleeping(settings.sleeping);
        disturbed_ = true;
    }
    loadWoken();
    moved_.clear();
    std::fill(movedMarks_.begin(), movedMarks_.end(), std::uint8_t{0});
    for (JointEntry& entry : joints_) {
        entry.force = {};
    }
    impacts_.clear();
    float const h = static_cast<float>(duration / settings.substeps);
    substep_ = h;
    for (int substep = 0; substep < settings.substeps; ++substep) {
        since_ = duration * substep / settings.substeps;
        applyDrags(static_cast<double>(h));
        applyJoints(h);
        world_.Step(h, settings.velocityIterations, settings.positionIterations);
        noteDragged();
        bool const last = substep + 1 == settings.substeps;
        anyAwake_ = false;
        for (std::size_t slot = 0; slot < bodies_.size(); ++slot) {
            BodyEntry& entry = bodies_[slot];
            if (awake_[slot] == 0) {
                continue;
            }
            movedMarks_[slot] = 1;
            if (!entry.body->IsAwake()) {
                awake_[slot] = 0;
            } else {
                anyAwake_ = true;
                if (last && settings.sleeping && drifts(entry)) {
                    entry.body->SetAwake(true); // starts its time to fall asleep anew
                }
            }
        }
        for (SlotIndex slot = 0; slot < joints_.size(); ++slot) {
            JointEntry& entry = joints_[slot];
            if (entry.joint != nullptr) {
                b2Vec2 const before = atOnce_ ? (1 / h) * atOnce_->impulse(slot) : b2Vec2_zero;
                entry.force += fromEngine(entry.joint->GetReactionForce(1 / h) + before) / settings.substeps;
            }
        }
    }
    noteMoved();
}

bool Box2dEngine::drifts(BodyEntry const& entry) const {
    b2Body& body = *entry.body;
    float const tolerance = b2_linearSleepTolerance;
    if (body.GetLinearVelocity().LengthSquared() > tolerance * tolerance) {
        return false; // too fast to fall asleep anyway
    }
    if (body.GetJointList() != nullptr) {
        return false;
    }
    for (b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
        if (edge->contact->IsTouching()) {
            return false;
        }
    }
    return length(fromEngine(entry.force)) > driftAcceleration * static_cast<double>(body.GetMass()) ||
           length(fromEngine(body.GetLinearVelocity())) > driftSpeed ||
           std::abs(static_cast<double>(body.GetAngularVelocity())) > driftSpin;
}

void Box2dEngine::noteMoved() {
    for (SlotIndex slot = 0; slot < bodies_.size(); ++slot) {
        if (movedMarks_[slot] != 0) {
            b2Body const& body = *bodies_[slot].body;
            moved_.push_back(
                {slot,
                 {fromEngine(body.GetPosition()), static_cast<double>(body.GetAngle()),
                  fromEngine(body.GetLinearVelocity()), static_cast<double>(body.GetAngularVelocity())}});
        }
    }
}

void Box2dEngine::BeginContact(b2Contact* contact) {
    noteTouch(contact, 1);
    if (impactsWanted_) {
        pressures_.begin(keyOf(contact));
    }
}

void Box2dEngine::EndContact(b2Contact* contact) {
    noteTouch(contact, -1);
    pressures_.end(keyOf(contact));
}

float Box2dEngine::speedGain(b2Body const* body) const {
    SlotIndex const slot = slotOf(body);
    float const mass = body->GetMass();
    return slot == noSlot || !(mass > 0) ? 0 : bodies_[slot].force.Length() * substep_ / mass;
}

// What a strong pull presses on something gains, in every substep, a speed that looks like an impact;
// bouncing that back would go on for ever. Only speed that the pull cannot explain bounces.
void Box2dEngine::PreSolve(b2Contact* contact, b2Manifold const*) {
    if (contact->GetRestitution() > 0) {
        float const explained =
            2 * (speedGain(contact->GetFixtureA()->GetBody()) + speedGain(contact->GetFixtureB()->GetBody()));
        contact->SetRestitutionThreshold(std::max(b2FixtureDef().restitutionThreshold, explained));
    }
}

void Box2dEngine::noteImpacts(bool wanted) {
    if (impactsWanted_ && !wanted) {
        pressures_.clear();
        impacts_.clear();
    }
    impactsWanted_ = wanted;
}

void Box2dEngine::PostSolve(b2Contact* contact, b2ContactImpulse const* impulse) {
    if (!impactsWanted_) {
        return;
    }
    float sum = 0;
    for (int i = 0; i < impulse->count; ++i) {
        sum += impulse->normalImpulses[i];
    }
    double const blow = pressures_.press(keyOf(contact), static_cast<double>(sum));
    b2Body const* const a = contact->GetFixtureA()->GetBody();
    b2Body const* const b = contact->GetFixtureB()->GetBody();
    auto const inverse = [](b2Body const* body) {
        return body->GetMass() > 0 ? 1 / static_cast<double>(body->GetMass()) : 0;
    };
    if (!(blow * (inverse(a) + inverse(b)) > faintestImpact * scale_)) {
        return;
    }
    b2WorldManifold world;
    contact->GetWorldManifold(&world);
    Impact impact;
    impact.a = bodies_[slotOf(a)].object;
    impact.b = bodies_[slotOf(b)].object;
    impact.normal = {static_cast<double>(world.normal.x), static_cast<double>(world.normal.y)};
    if (impact.b < impact.a) {
        std::swap(impact.a, impact.b);
        impact.normal = -impact.normal;
    }
    for (int i = 0; i < impulse->count; ++i) {
        double const share = static_cast<double>(impulse->normalImpulses[i]) / static_cast<double>(sum);
        impact.point += share * fromEngine(world.points[i]);
    }
    impact.impulse = blow / scale_;
    impact.since = since_;
    impacts_.push_back(impact);
}

void Box2dEngine::noteTouch(b2Contact* contact, int delta) {
    b2Body* const bodies[2] = {contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody()};
    ObjectId const a = bodies_[slotOf(bodies[0])].object;
    ObjectId const b = bodies_[slotOf(bodies[1])].object;
    touches_.push_back(a < b ? TouchChange{a, b, delta} : TouchChange{b, a, delta});
    for (b2Body* const body : bodies) {
        if (body->IsAwake()) {
            wakeAll(body); // Box2D has just woken it: a touch has begun or ended
        }
    }
}

void Box2dEngine::addContactPatches(std::vector<ContactPatch>& patches) const {
    for (b2Contact const* contact = world_.GetContactList(); contact != nullptr;
         contact = contact->GetNext()) {
        b2Manifold const& manifold = *contact->GetManifold();
        if (!contact->IsTouching() || manifold.pointCount == 0) {
            continue;
        }
        b2WorldManifold world;
        contact->GetWorldManifold(&world);
        ContactPatch patch;
        patch.a = bodies_[slotOf(contact->GetFixtureA()->GetBody())].object;
        patch.b = bodies_[slotOf(contact->GetFixtureB()->GetBody())].object;
        double const sign = patch.a < patch.b ? 1 : -1;
        if (sign < 0) {
            std::swap(patch.a, patch.b);
        }
        patch.normal = sign * Vec2{static_cast<double>(world.normal.x), static_cast<double>(world.normal.y)};
        patch.count = manifold.pointCount;
        for (int i = 0; i < manifold.pointCount; ++i) {
            auto const n = static_cast<std::size_t>(i);
            patch.points[n] = fromEngine(world.points[i]);
            patch.normalImpulse[n] = static_cast<double>(manifold.points[i].normalImpulse) / scale_;
            patch.tangentImpulse[n] = static_cast<double>(manifold.points[i].tangentImpulse) / scale_;
        }
        patches.push_back(patch);
    }
}

std::unique_ptr<Engine> makeBox2dEngine(double scale) {
    return std::make_unique<Box2dEngine>(scale);
}

} // namespace trembler
