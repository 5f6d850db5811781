#include "insight/miss/current/switched_links.hpp"

#include "audio/effect/properties/acoustics.hpp"
#include "audio/effect/properties/loudness.hpp"
#include "insight/miss/condition_miss.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "physics/motor/properties.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::insight {
namespace {

/// m. Little, so that the fuse is named rather than a place where something could be laid across instead.
constexpr double blownCost = 0.05;

} // namespace

SwitchedLinks::SwitchedLinks(World const& world) {
    Store const& store = world.store();
    if (auto const* const generators = store.findColumn<Generator>()) {
        for (ObjectId const id : generators->owners()) {
            Generator const& generator = *generators->find(id);
            AngularVelocity const* const turning = world.find<AngularVelocity>(id);
            double const speed = turning == nullptr ? 0 : std::abs(turning->value);
            add(id, generator.source, GapReason::slow, id, degrees(speed), degrees(generator.speed));
        }
    }
    if (auto const* const sensors = store.findColumn<SoundSensor>()) {
        Loudness const* const loudness = world.find<Loudness>();
        Contacts const* const contacts = world.find<Contacts>();
        for (ObjectId const id : sensors->owners()) {
            SoundSensor const& sensor = *sensors->find(id);
            double const level = loudness == nullptr ? 0 : std::max(0.0, loudness->at(id));
            if (sensor.a.valid() || sensor.b.valid()) {
                add(sensor.a, sensor.b, GapReason::quiet, id, level, sensor.threshold);
                continue;
            }
            std::set<ObjectId> touching;
            for (std::size_t i = 0; contacts != nullptr && i < contacts->current.size(); ++i) {
                TouchingPair const& pair = contacts->current[i];
                if ((pair.a == id || pair.b == id) &&
                    world.find<Conductor>(pair.a == id ? pair.b : pair.a) != nullptr) {
                    touching.insert(pair.a == id ? pair.b : pair.a);
                }
            }
            for (ObjectId const other : touching) {
                add(*touching.begin(), other, GapReason::quiet, id, level, sensor.threshold);
            }
        }
    }
    if (auto const* const fuses = store.findColumn<Fuse>()) {
        for (ObjectId const id : fuses->owners()) {
            if (fuses->find(id)->blown) {
                blown_.insert(id);
            }
        }
    }
}

void SwitchedLinks::add(ObjectId a, ObjectId b, GapReason reason, ObjectId by, double is, double needed) {
    if (!a.valid() || !b.valid() || a == b) {
        return;
    }
    CircuitGap gap;
    gap.a = std::min(a, b);
    gap.b = std::max(a, b);
    gap.reason = reason;
    gap.by = by;
    gap.is = is;
    gap.needed = needed;
    double const lacking = needed > 0 ? std::clamp(1 - is / needed, 0.0, 1.0) : 0;
    gap.cost = std::max(leastGapCost, lacking * typicalDistance);
    auto const [at, isNew] = links_.emplace(std::pair(gap.a, gap.b), gap);
    if (!isNew && gap.cost < at->second.cost) {
        at->second = gap;
    }
}

std::optional<CircuitGap> SwitchedLinks::between(ObjectId a, ObjectId b) const {
    auto const at = links_.find({a, b});
    return at == links_.end() ? std::nullopt : std::optional(at->second);
}

bool SwitchedLinks::addBlown(CircuitGap& gap) const {
    for (ObjectId const id : {gap.a, gap.b}) {
        if (blown_.contains(id)) {
            gap.reason = GapReason::blown;
            gap.by = id;
            gap.cost += blownCost; // a path through it has two such gaps
            return true;
        }
    }
    return false;
}

} // namespace trembler::insight
