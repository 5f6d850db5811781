#include "insight/miss/obstacles.hpp"

#include "insight/miss/idle_devices.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace trembler::insight {
namespace {

bool isMagnet(World const& world, ObjectId id) {
    MagneticStrength const* const strength = world.find<MagneticStrength>(id);
    return strength != nullptr && strength->strength > 0;
}

/// The magnet that the miss is about, or the one that would pull the object most strongly if it were on, by
/// the inverse square; an invalid id if there is none.
ObjectId magnetFor(Miss const& miss, World const& world, ObjectId mover) {
    for (ObjectId const id : miss.objects) {
        if (id != mover && isMagnet(world, id)) {
            return id;
        }
    }
    ObjectId strongest;
    double most = 0;
    auto const* const column = world.store().findColumn<MagneticStrength>();
    Position const* const from = world.find<Position>(mover);
    if (column == nullptr || from == nullptr) {
        return strongest;
    }
    for (ObjectId const id : column->owners()) {
        Position const* const position = world.find<Position>(id);
        if (id == mover || position == nullptr || !isMagnet(world, id)) {
            continue;
        }
        double const distance = length(position->value - from->value);
        double const pull =
            column->find(id)->strength / (distance * distance + magneticSoftening * magneticSoftening);
        if (pull > most) {
            most = pull;
            strongest = id;
        }
    }
    return strongest;
}

Vec2 magneticForceOn(World const& world, ObjectId id) {
    Vec2 sum;
    if (auto const* const magnetic = world.find<MagneticForce>()) {
        for (MagneticForce::Entry const& entry : magnetic->forces) {
            if (entry.object == id) {
                sum += entry.force;
            }
        }
    }
    return sum;
}

double weightOf(World const& world, ObjectId id) {
    auto const* const gravity = world.find<GravityForce>();
    if (gravity == nullptr) {
        return 0;
    }
    auto const at = std::find_if(gravity->forces.begin(), gravity->forces.end(),
                                 [&](GravityForce::Entry const& entry) { return entry.object == id; });
    return at == gravity->forces.end() ? 0 : length(at->force);
}

bool isMagnetic(World const& world, ObjectId id) {
    MagneticStrength const* const strength = world.find<MagneticStrength>(id);
    return strength != nullptr && strength->susceptibility > 0 && strength->strength <= 0;
}

bool isJointed(World const& world, ObjectId id) {
    auto const* const joints = world.store().findColumn<Joint>();
    return joints != nullptr &&
           std::any_of(joints->owners().begin(), joints->owners().end(), [&](ObjectId owner) {
               Joint const& joint = *joints->find(owner);
               return joint.a == id || joint.b == id;
           });
}

} // namespace

void addSleepingCoils(Miss& miss, World const& world, CircuitSight& circuits) {
    auto const* const coils = world.store().findColumn<Electromagnet>();
    std::set<ObjectId> movers;
    for (CircuitGap const& gap : miss.gaps) {
        for (ObjectId const id : {gap.a, gap.b}) {
            if (gap.reason == GapReason::apart && isMagnetic(world, id) && isJointed(world, id)) {
                movers.insert(id);
            }
        }
    }
    if (coils == nullptr || movers.empty()) {
        return;
    }
    auto const moves = [&](ObjectId coil) {
        Position const* const at = world.find<Position>(coil);
        return at != nullptr && std::any_of(movers.begin(), movers.end(), [&](ObjectId mover) {
                   Position const* const from = world.find<Position>(mover);
                   return from != nullptr && mover != coil && length(from->value - at->value) <= coilReach;
               });
    };
    for (ObjectId const coil : coils->owners()) {
        bool const asked = std::find(miss.objects.begin(), miss.objects.end(), coil) != miss.objects.end();
        if (!asked && isIdle(world, coil) && moves(coil)) {
            miss.besides.push_back(missOfIdle(world, coil, circuits));
        }
    }
}

void addObstacles(Miss& miss, World const& world, CircuitSight& circuits) {
    auto const mover = std::find_if(miss.objects.begin(), miss.objects.end(),
                                    [&](ObjectId id) { return isMagnetic(world, id); });
    if (mover == miss.objects.end()) {
        return;
    }
    ObjectId const magnet = magnetFor(miss, world, *mover);
    if (!magnet.valid()) {
        return;
    }
    if (isIdle(world, magnet)) {
        miss.besides.push_back(missOfIdle(world, magnet, circuits));
        return;
    }
    Miss other;
    other.objects = {magnet, *mover};
    Vec2 const pull = magneticForceOn(world, *mover);
    double const missing = weightOf(world, *mover) - length(pull);
    bool const isWanted = std::find(miss.objects.begin(), miss.objects.end(), magnet) != miss.objects.end();
    if (missing > 0) {
        other.lack = Lack::force;
        other.by = missing;
        miss.besides.push_back(std::move(other));
    } else if (!isWanted && dot(pull, miss.to - miss.from) < 0) {
        other.lack = Lack::held;
        other.by = 1;
        miss.besides.push_back(std::move(other));
    }
}

} // namespace trembler::insight
