#include "tests/physics/electricity/circuit_world.hpp"

#include "tests/support/initial_wire.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>

namespace trembler::test {

void ScriptedCollisions::advance(Access& access) {
    Contacts& contacts = access.provide<Contacts>();
    std::vector<TouchingPair> now;
    for (Touching const& touching : access.read<Touching>().values()) {
        now.insert(now.end(), touching.pairs.begin(), touching.pairs.end());
    }
    std::sort(now.begin(), now.end());
    contacts.begun.clear();
    contacts.ended.clear();
    for (TouchingPair& pair : now) {
        auto const before = std::lower_bound(contacts.current.begin(), contacts.current.end(), pair);
        if (before != contacts.current.end() && *before == pair) {
            pair.event = before->event;
        } else {
            pair.event = access.event("contact begun", {pair.a, pair.b}, {});
            contacts.begun.push_back(pair);
        }
    }
    for (TouchingPair pair : contacts.current) {
        if (!std::binary_search(now.begin(), now.end(), pair)) {
            pair.event = access.event("contact ended", {pair.a, pair.b}, {});
            contacts.ended.push_back(pair);
        }
    }
    contacts.current = now;
}

void ElectricityFromScript::apply(Access& access) {
    for (Script const& script : access.read<Script>().values()) {
        for (Script::Line const& line : script.lines) {
            if (line.script == scissors && number_ == 0) {
                access.call(CutWire{line.a, line.b});
            }
            if (line.script != number_) {
                continue;
            }
            if (line.add) {
                access.call(AddConnection{{line.a, line.b}});
            } else {
                access.call(RemoveConnection{{line.a, line.b}});
            }
        }
    }
    for (Holding const& holding : access.read<Holding>().values()) {
        for (Holding::Connection const& held : holding.connections) {
            if (held.script == number_) {
                access.call(HoldConnection{{held.a, held.b}});
            }
        }
        for (Holding::Voltage const& held : holding.voltages) {
            if (held.script == number_) {
                access.call(AddVoltage{held.object, held.voltage});
            }
        }
    }
}

void registerScripts(Registry& registry) {
    constexpr auto script = [](std::string_view name, std::size_t number) {
        return ScriptNumber{.text{.name = name, .effect = "test", .level = "", .work = "As the test states."},
                            .number = number};
    };
    static constexpr std::array<ScriptNumber, scripts> all{script("Electricity <- Script 1", 0),
                                                           script("Electricity <- Script 2", 1),
                                                           script("Electricity <- Script 3", 2)};
    for (ScriptNumber const& each : all) {
        registry.component<ElectricityFromScript>(each);
    }
}

std::int32_t countBy(CallerCounts const& counts, std::string_view name) {
    for (CallerCounts::Entry const& entry : counts.entries()) {
        if (entry.caller.name() == name) {
            return entry.count;
        }
    }
    return 0;
}

std::int32_t countBy(CallerCounts const& counts, std::size_t script) {
    return countBy(counts, "Electricity <- Script " + std::to_string(script + 1));
}

void PopulationFromScript::apply(Access& access) {
    for (Script const& script : access.read<Script>().values()) {
        for (ObjectId const id : script.destroys) {
            access.call(DestroyObject{id});
        }
        for (CreateObject const& create : script.creates) {
            access.call(create);
        }
    }
}

CircuitWorld::CircuitWorld(WorldOptions options) {
    registerRuntime(registry_);
    registry_.component<ScriptedCollisions>();
    registerElectricity(registry_);
    registry_.component<PopulationFromScript>();
    registerScripts(registry_);
    world_ = std::make_unique<World>(registry_, std::move(options));
    director_ = store().create("director");
    store().column<Script>().set(director_, {});
    store().column<Holding>().set(director_, {});
    store().column<Touching>().set(director_, {});
}

ObjectId CircuitWorld::conductor(std::string const& name, std::string const& network) {
    ObjectId const id = store().create(name);
    store().column<Conductor>().set(id, {network});
    return id;
}

ObjectId CircuitWorld::source(std::string const& name, std::string const& network) {
    ObjectId const id = conductor(name);
    store().column<ElectricalSource>().set(id, {network});
    return id;
}

ObjectId CircuitWorld::returning(std::string const& name, std::string const& network) {
    ObjectId const id = conductor(name);
    store().column<ElectricalReturn>().set(id, {network});
    return id;
}

void CircuitWorld::wire(std::vector<std::vector<std::string>> const& paths) {
    for (std::vector<std::string> const& path : paths) {
        for (std::size_t i = 0; i < path.size(); ++i) {
            if (!(*this)[path[i]].valid()) {
                conductor(path[i]);
            }
        }
        for (std::size_t i = 1; i < path.size(); ++i) {
            if (auto const wrong = connectInitially(store(), (*this)[path[i - 1]], (*this)[path[i]])) {
                throw std::logic_error(*wrong);
            }
        }
    }
}

void CircuitWorld::write(std::vector<Script::Line> lines, std::vector<ObjectId> destroys,
                         std::vector<CreateObject> creates) {
    store().column<Script>().set(director_, {std::move(lines), std::move(destroys), std::move(creates)});
}

void CircuitWorld::call(std::vector<Script::Line> lines, std::vector<ObjectId> destroys,
                        std::vector<CreateObject> creates) {
    write(std::move(lines), std::move(destroys), std::move(creates));
    world_->step();
    write({});
    world_->step();
}

void CircuitWorld::hold(Holding holding) {
    store().column<Holding>().set(director_, std::move(holding));
    world_->step();
    world_->step();
}

void CircuitWorld::connect(std::string const& a, std::string const& b, std::size_t script) {
    call({{(*this)[a], (*this)[b], script, true}});
}

void CircuitWorld::disconnect(std::string const& a, std::string const& b, std::size_t script) {
    CallerCounts const counts = connectionBetween(store(), (*this)[a], (*this)[b]);
    bool const added = countBy(counts, script) > 0;
    call({{(*this)[a], (*this)[b], added || counts.of(CallerId::level()) == 0 ? script : scissors, false}});
}

void CircuitWorld::touch(std::vector<std::pair<std::string, std::string>> const& pairs) {
    Touching touching;
    for (auto const& [first, second] : pairs) {
        ObjectId const a = (*this)[first];
        ObjectId const b = (*this)[second];
        touching.pairs.push_back({std::min(a, b), std::max(a, b), {}});
    }
    std::sort(touching.pairs.begin(), touching.pairs.end());
    store().column<Touching>().set(director_, std::move(touching));
}

bool CircuitWorld::isOn(ObjectId id) const {
    auto const* const state = world_->find<ElectricalState>();
    return state != nullptr && state->isOn(id);
}

std::vector<std::string> CircuitWorld::on() const {
    std::vector<std::string> names;
    for (ElectricalState::Entry const& entry : state().byIndex) {
        if (entry.object.valid() && entry.on) {
            names.push_back(world_->store().nameOf(entry.object));
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

ComponentStatus CircuitWorld::status(std::string_view componentName) const {
    for (ComponentStatus const& status : world_->status()) {
        if (status.info->text.name == componentName) {
            return status;
        }
    }
    throw std::logic_error("no component named " + std::string(componentName));
}

} // namespace trembler::test
