#include "insight/why/scene_facts.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "puzzle/goals/words/lamp.hpp"
#include "runtime/placement.hpp"

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

/// The objects that joints connect with one another, through others as well; fixed ones connect nothing.
std::map<std::string, std::set<std::string>> tiedIn(Store const& store) {
    std::map<std::string, std::set<std::string>> tied;
    auto const* const joints = store.findColumn<Joint>();
    for (ObjectId const id : joints == nullptr ? std::span<ObjectId const>() : joints->owners()) {
        Joint const& joint = *joints->find(id);
        if (!joint.b.valid() || store.has<Fixed>(joint.a) || store.has<Fixed>(joint.b)) {
            continue;
        }
        std::string const a = store.nameOf(joint.a);
        std::string const b = store.nameOf(joint.b);
        std::set<std::string> all{a, b};
        all.insert(tied[a].begin(), tied[a].end());
        all.insert(tied[b].begin(), tied[b].end());
        for (std::string const& name : all) {
            tied[name] = all;
        }
    }
    return tied;
}

} // namespace

SceneFacts factsOf(LevelRun const& run) {
    World const& world = run.world();
    Store const& store = world.store();
    SceneFacts facts;
    facts.fixed = ownersOf<Fixed>(store);
    facts.conductors = ownersOf<Conductor>(store);
    facts.tied = tiedIn(store);
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
    return facts;
}

} // namespace trembler::insight
