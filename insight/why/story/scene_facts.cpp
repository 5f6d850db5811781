#include "insight/why/story/scene_facts.hpp"

#include "audio/effect/properties/acoustics.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/motor/properties.hpp"
#include "puzzle/goals/words/lamp.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace trembler::insight {
namespace {

template <class P>
std::set<std::string> ownersOf(Store const& store) {
    std::set<std::string> names;
    if (auto const* const column = store.findColumn<P>()) {
        for (ObjectId const id : column->owners()) {
            names.insert(store.nameOf(id));
        }
    }
    return names;
}

/// Of each object that joints connect with others, through others as well, the number of its group; fixed
/// objects connect nothing. O(joints), but for the names.
std::map<std::string, std::size_t> tiedIn(Store const& store) {
    std::vector<std::uint32_t> above(
        store.objects().indexBound()); // a forest: the root is the group's number
    std::iota(above.begin(), above.end(), 0U);
    auto const rootOf = [&](std::uint32_t i) {
        while (above[i] != i) {
            i = above[i] = above[above[i]];
        }
        return i;
    };
    std::vector<ObjectId> ends;
    auto const* const joints = store.findColumn<Joint>();
    for (ObjectId const id : joints == nullptr ? std::span<ObjectId const>() : joints->owners()) {
        Joint const& joint = *joints->find(id);
        if (joint.a.valid() && joint.b.valid() && !store.has<Fixed>(joint.a) && !store.has<Fixed>(joint.b)) {
            above[rootOf(joint.a.index)] = rootOf(joint.b.index);
            ends.insert(ends.end(), {joint.a, joint.b});
        }
    }
    std::map<std::string, std::size_t> tied;
    for (ObjectId const id : ends) {
        tied.emplace(store.nameOf(id), rootOf(id.index));
    }
    return tied;
}

/// The roles of what is welded to wheels.
std::map<std::string, std::size_t> rolesIn(Store const& store) {
    std::set<ObjectId> wheels;
    auto const* const joints = store.findColumn<Joint>();
    std::span<ObjectId const> const all = joints == nullptr ? std::span<ObjectId const>() : joints->owners();
    for (ObjectId const id : all) {
        Joint const& joint = *joints->find(id);
        if (joint.form == JointForm::hinge) {
            wheels.insert({joint.a, joint.b});
        }
    }
    std::map<std::pair<ObjectId, std::uint32_t>, std::set<ObjectId>> alike; // by wheel and part
    for (ObjectId const id : all) {
        Joint const& joint = *joints->find(id);
        for (auto const& [piece, wheel] : {std::pair{joint.a, joint.b}, std::pair{joint.b, joint.a}}) {
            bool const welded = joint.form == JointForm::weld && piece.valid() && wheel.valid();
            auto const part = welded ? store.originOf(piece).prototype : std::nullopt;
            if (part && wheels.contains(wheel)) {
                alike[{wheel, *part}].insert(piece);
            }
        }
    }
    std::map<std::string, std::size_t> roles;
    std::size_t number = 0;
    for (auto const& [key, pieces] : alike) {
        ++number;
        for (ObjectId const piece : pieces) {
            if (pieces.size() > 1) {
                roles.emplace(store.nameOf(piece), number);
            }
        }
    }
    return roles;
}

/// Whether it is "object" and a number: its author gave it no name of its own.
bool isNumbered(std::string const& name) {
    constexpr std::string_view any = "object ";
    return name.size() > any.size() && name.starts_with(any) &&
           std::all_of(name.begin() + any.size(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Objects of one part are numbered in the order of the level, with numbers that no other name has.
std::map<std::string, std::string> spokenNames(Store const& store,
                                               std::map<std::string, Vec2> const& places) {
    std::map<std::string, std::vector<ObjectId>> ofPart;
    if (auto const* const positions = store.findColumn<Position>()) {
        for (ObjectId const id : positions->owners()) {
            Origin const origin = store.originOf(id);
            Prototype const* const part =
                origin.prototype ? store.prototypes().find(*origin.prototype) : nullptr;
            if (part != nullptr && isNumbered(store.nameOf(id))) {
                ofPart[part->name].push_back(id);
            }
        }
    }
    std::map<std::string, std::string> spoken;
    for (auto& [part, objects] : ofPart) {
        std::sort(objects.begin(), objects.end(), [&](ObjectId a, ObjectId b) {
            return store.originOf(a).number < store.originOf(b).number;
        });
        int number = 0;
        for (ObjectId const id : objects) {
            std::string name = part;
            while (objects.size() > 1 || places.contains(name)) {
                name = part + " " + std::to_string(++number);
                if (!places.contains(name)) {
                    break;
                }
            }
            spoken.emplace(store.nameOf(id), name);
        }
    }
    return spoken;
}

} // namespace

SceneFacts factsOf(LevelRun const& run) {
    World const& world = run.world();
    Store const& store = world.store();
    SceneFacts facts;
    facts.fixed = ownersOf<Fixed>(store);
    facts.conductors = ownersOf<Conductor>(store);
    facts.conductors.merge(ownersOf<SoundSensor>(store));
    facts.motors = ownersOf<ElectricMotor>(store);
    facts.magnets = ownersOf<Magnet>(store);
    facts.tied = tiedIn(store);
    facts.roles = rolesIn(store);
    if (auto const* const positions = store.findColumn<Position>()) {
        for (ObjectId const id : positions->owners()) {
            std::string const name = store.nameOf(id);
            facts.places.emplace(name, (*positions)[id].value);
            if (isLamp(world, id)) {
                facts.lamps.insert(name);
            }
            if (auto const placement = run.placementOf(id)) {
                facts.placementOf.emplace(name, *placement);
            }
        }
    }
    facts.spoken = spokenNames(store, facts.places);
    return facts;
}

} // namespace trembler::insight
