#include "tests/conventional/play.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/motor/properties.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/object/name.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <fstream>

namespace trembler::conventional {
namespace {

std::set<std::string> allButWeight() {
    std::set<std::string> without = dispensableGameEffects();
    without.erase("gravity");
    return without;
}

Pose poseOf(World const& world, ObjectId id) {
    Pose pose;
    if (!world.store().alive(id)) {
        return pose;
    }
    pose.there = true;
    if (Position const* const position = world.find<Position>(id)) {
        pose.at = position->value;
    }
    if (Rotation const* const rotation = world.find<Rotation>(id)) {
        pose.angle = rotation->angle;
    }
    return pose;
}

bool isIn(std::vector<TouchingPair> const& pairs, ObjectId a, ObjectId b) {
    return std::binary_search(pairs.begin(), pairs.end(), TouchingPair{std::min(a, b), std::max(a, b), {}});
}

std::map<std::string, ObjectId> objectsOf(World const& world) {
    std::map<std::string, ObjectId> all;
    if (auto const* const names = world.store().findColumn<Name>()) {
        for (std::size_t row = 0; row < names->size(); ++row) {
            all.emplace(names->values()[row].value, names->owners()[row]);
        }
    }
    return all;
}

} // namespace

Pose Film::end(std::string const& name) const {
    auto const at = poses.back().find(name);
    return at == poses.back().end() ? Pose{} : at->second;
}

Stage::Stage() {
    registerEffects(bodies_, allButWeight());
}

nlohmann::json Stage::levelOf(std::string const& file) const {
    std::ifstream in(std::filesystem::path(TREMBLER_SOURCE_DIR) / file);
    nlohmann::json level = nlohmann::json::parse(in);
    for (char const* key :
         {"solutions", "goals", "toolbox", "hints", "placing", "demonstration", "task", "texts"}) {
        level.erase(key);
    }
    return level;
}

LevelFile Stage::read(Registry const& registry, Setting const& setting, bool cuts) const {
    nlohmann::json level = setting.level;
    nlohmann::json inputs = setting.inputs;
    if (cuts) {
        for (Setting::Cut const& cut : setting.cuts) {
            inputs.push_back({{"frame", cut.frame}, {"cut", {cut.a, cut.b}}});
        }
    }
    std::stable_sort(inputs.begin(), inputs.end(), [](nlohmann::json const& a, nlohmann::json const& b) {
        return a.at("frame").get<int>() < b.at("frame").get<int>();
    });
    level["solutions"] = {{{"name", "deeds"}, {"frames", 600}, {"inputs", inputs}}};
    return readLevel(registry, JsonDocument::parse(level.dump(), "perturbed scene"));
}

Film Stage::play(Setting const& setting, Kind kind, Watch const& watch, ScriptSet const& scripts) const {
    auto const game = std::make_shared<Game>();
    Registry scripted;
    Registry const* registry = kind == Kind::physical ? &data_.registry : &bodies_;
    if (kind == Kind::conventional) {
        registerEffects(scripted, allButWeight());
        registerScripts(scripted, scripts, setting, game);
        registry = &scripted;
    }
    LevelFile const level = read(*registry, setting, kind == Kind::physical);
    Session session(*registry, data_.parts, level);
    session.load(level.solutions.front());
    auto const objects = objectsOf(session.world());
    Film film;
    auto const shoot = [&] {
        std::map<std::string, Pose> now;
        for (auto const& [name, id] : objects) {
            now.emplace(name, poseOf(session.world(), id));
        }
        film.poses.push_back(std::move(now));
    };
    auto const idOf = [&](std::string const& name) {
        auto const at = objects.find(name);
        return at == objects.end() ? ObjectId{} : at->second;
    };
    shoot();
    for (std::uint64_t frame = 1; frame <= watch.frames; ++frame) {
        session.step();
        shoot();
        Contacts const& contacts = *session.world().find<Contacts>();
        ObjectId const a = idOf(watch.pair.first);
        ObjectId const b = idOf(watch.pair.second);
        if (isIn(contacts.begun, a, b) || isIn(contacts.brief, a, b)) {
            film.hits.push_back(frame);
        }
    }
    if (kind == Kind::physical) {
        auto const* const state = session.world().find<ElectricalState>();
        for (std::string const& device : watch.devices) {
            if (state != nullptr && state->isOn(idOf(device))) {
                film.on.insert(device);
            }
        }
    } else {
        film.on = game->lit;
        film.rings = game->rings;
    }
    if (auto const* const joints = session.world().store().findColumn<Joint>()) {
        for (ObjectId const id : joints->owners()) {
            film.joints.insert(session.world().store().nameOf(id));
        }
    }
    return film;
}

Facts Stage::factsOf(Setting const& setting) const {
    LevelFile const level = read(data_.registry, setting, false);
    Session const session(data_.registry, data_.parts, level);
    World const& world = session.world();
    Facts facts;
    for (auto const& [name, id] : objectsOf(world)) {
        Fact fact;
        fact.start = poseOf(world, id);
        if (Shape const* const shape = world.find<Shape>(id)) {
            fact.shape = *shape;
        }
        fact.fixed = world.find<Fixed>(id) != nullptr;
        if (Mass const* const mass = world.find<Mass>(id)) {
            fact.mass = mass->value;
        }
        fact.conductor = world.find<Conductor>(id) != nullptr;
        fact.source = world.find<ElectricalSource>(id) != nullptr;
        fact.earth = world.find<ElectricalReturn>(id) != nullptr;
        fact.electromagnet = world.find<Electromagnet>(id) != nullptr;
        if (MagneticStrength const* const magnetic = world.find<MagneticStrength>(id)) {
            fact.susceptibility = magnetic->susceptibility;
            fact.strength = magnetic->strength;
        }
        if (MagneticPoles const* const poles = world.find<MagneticPoles>(id)) {
            if (poles->poles == PoleSet::north || poles->poles == PoleSet::both) {
                fact.poles.push_back(poles->north);
            }
            if (poles->poles == PoleSet::south || poles->poles == PoleSet::both) {
                fact.poles.push_back(poles->south);
            }
        }
        if (ElectricMotor const* const motor = world.find<ElectricMotor>(id)) {
            fact.motorTorque = motor->torque;
        }
        facts.emplace(name, std::move(fact));
    }
    for (auto const& object : setting.level.at("objects")) {
        facts.at(object.at("name")).part = object.value("part", std::string());
    }
    return facts;
}

} // namespace trembler::conventional
