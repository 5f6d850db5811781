#include "insight/why/scene_facts.hpp"

#include "physics/dynamics/properties/body.hpp"
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

} // namespace

SceneFacts factsOf(LevelRun const& run) {
    World const& world = run.world();
    Store const& store = world.store();
    SceneFacts facts;
    facts.fixed = ownersOf<Fixed>(store);
    facts.conductors = ownersOf<Conductor>(store);
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
