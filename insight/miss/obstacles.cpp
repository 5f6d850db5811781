#include "insight/miss/obstacles.hpp"

#include "physics/electricity/properties/electrical.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <limits>

namespace trembler::insight {
namespace {

bool isMagnet(World const& world, ObjectId id) {
    MagneticStrength const* const strength = world.find<MagneticStrength>(id);
    return strength != nullptr && strength->strength > 0;
}

/// The magnet that the miss is about, or the nearest one; an invalid id if there is none.
ObjectId magnetFor(Miss const& miss, World const& world, ObjectId mover) {
    for (ObjectId const id : miss.objects) {
        if (id != mover && isMagnet(world, id)) {
            return id;
        }
    }
    ObjectId nearest;
    double least = std::numeric_limits<double>::infinity();
    auto const* const column = world.store().findColumn<MagneticStrength>();
    Position const* const from = world.find<Position>(mover);
    if (column == nullptr || from == nullptr) {
        return nearest;
    }
    for (ObjectId const id : column->owners()) {
        Position const* const position = world.find<Position>(id);
        if (id == mover || position == nullptr || !isMagnet(world, id)) {
            continue;
        }
        if (double const distance = length(position->value - from->value); distance < least) {
            least = distance;
            nearest = id;
        }
    }
    return nearest;
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

} // namespace

void addObstacles(Miss& miss, World const& world, CircuitSight& circuits) {
    auto const mover = std::find_if(miss.objects.begin(), miss.objects.end(), [&](ObjectId id) {
        MagneticStrength const* const strength = world.find<MagneticStrength>(id);
        return strength != nullptr && strength->susceptibility > 0 && strength->strength <= 0;
    });
    if (mover == miss.objects.end()) {
        return;
    }
    ObjectId const magnet = magnetFor(miss, world, *mover);
    if (!magnet.valid()) {
        return;
    }
    Miss other;
    other.objects = {magnet};
    auto const* const state = world.find<ElectricalState>();
    bool const switched = world.find<Electromagnet>(magnet) != nullptr;
    if (switched && (state == nullptr || !state->isOn(magnet))) {
        CircuitCut const& cut = circuits.cutAt(world, magnet);
        other.lack = cut.gaps.empty() ? Lack::change : Lack::gap;
        other.by = cut.gaps.empty() ? 1 : cut.width;
        other.gaps = cut.gaps;
        miss.besides.push_back(std::move(other));
        return;
    }
    double const missing = weightOf(world, *mover) - length(magneticForceOn(world, *mover));
    if (missing > 0) {
        other.lack = Lack::force;
        other.by = missing;
        other.objects = {magnet, *mover};
        miss.besides.push_back(std::move(other));
    }
}

} // namespace trembler::insight
