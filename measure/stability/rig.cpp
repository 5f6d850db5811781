#include "measure/stability/rig.hpp"

#include "physics/gravity/properties.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler::stability {
namespace {

Registry const& registry() {
    static Registry const shared = [] {
        Registry made;
        registerEffects(made);
        return made;
    }();
    return shared;
}

} // namespace

double Jitter::operator()() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    z ^= z >> 31U;
    return static_cast<double>(z >> 11U) * 0x1.0p-52 - 1;
}

Rig::Rig(Setting const& setting, std::uint64_t seed, Vec2 gravity)
    : jitter(seed),
      world(std::make_unique<World>(registry(), WorldOptions{.threads = setting.threads,
                                                             .detail = {{"dynamics", setting.engine}},
                                                             .periods = {},
                                                             .trace = false,
                                                             .rowsWorthThreads = 0})) {
    ObjectId const self = world->store().create("world");
    if (!(gravity == Vec2{})) {
        give(self, GravityField{gravity});
    }
    DynamicsSettings solver = setting.solver;
    solver.sleeping = false;
    give(self, solver);
}

ObjectId Rig::body(ShapePiece piece, Vec2 at, double mass, double angle) {
    ObjectId const id = world->store().create(fmt::format("body {}", count_++));
    give(id, Shape{{std::move(piece)}});
    give(id, Position{at});
    give(id, Rotation{angle});
    give(id, Mass{mass});
    bodies_.push_back(id);
    places_.push_back(at);
    return id;
}

ObjectId Rig::fixed(ShapePiece piece, Vec2 at, double angle) {
    ObjectId const id = world->store().create(fmt::format("fixed {}", count_++));
    give(id, Shape{{std::move(piece)}});
    give(id, Position{at});
    give(id, Rotation{angle});
    give(id, Fixed{});
    return id;
}

ObjectId Rig::tie(JointForm form, ObjectId a, ObjectId b, Vec2 at) {
    Joint joint;
    joint.form = form;
    joint.a = a;
    joint.b = b;
    joint.at = at;
    ObjectId const id = world->store().create(fmt::format("joint {}", count_++));
    give(id, joint);
    ties_.push_back({a, b, toBody(a, at), toBody(b, at)});
    return id;
}

void Rig::start() {
    if (!started_) {
        world->start();
        started_ = true;
    }
}

void Rig::step() {
    start();
    world->step();
}

Vec2 Rig::at(ObjectId id) const {
    return world->find<Position>(id)->value;
}

Vec2 Rig::velocity(ObjectId id) const {
    Velocity const* const found = world->find<Velocity>(id);
    return found == nullptr ? Vec2{} : found->value;
}

double Rig::angle(ObjectId id) const {
    return world->find<Rotation>(id)->angle;
}

double Rig::drift() const {
    double worst = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        worst = std::max(worst, length(at(bodies_[i]) - places_[i]));
    }
    return worst;
}

double Rig::sidewaysDrift() const {
    double worst = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        worst = std::max(worst, std::abs(at(bodies_[i]).x - places_[i].x));
    }
    return worst;
}

double Rig::fastest() const {
    double most = 0;
    for (ObjectId const id : bodies_) {
        most = std::max(most, length(velocity(id)));
    }
    return most;
}

Vec2 Rig::toBody(ObjectId id, Vec2 point) const {
    return id.valid() ? rotated(point - at(id), -angle(id)) : point;
}

Vec2 Rig::toWorld(ObjectId id, Vec2 point) const {
    return id.valid() ? at(id) + rotated(point, angle(id)) : point;
}

double Rig::worstGap() const {
    double worst = 0;
    for (Tie const& tie : ties_) {
        worst = std::max(worst, length(toWorld(tie.a, tie.onA) - toWorld(tie.b, tie.onB)));
    }
    return worst;
}

bool Rig::finite() const {
    return std::all_of(bodies_.begin(), bodies_.end(), [&](ObjectId id) {
        return isFinite(at(id)) && isFinite(velocity(id)) && std::isfinite(angle(id));
    });
}

} // namespace trembler::stability
