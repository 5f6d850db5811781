#include "tests/puzzle/goals/stage.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/material.hpp"
#include "runtime/frame/settings.hpp"
#include "runtime/level/read/read_part.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"

#include <algorithm>

namespace trembler {

GoalStage::GoalStage(std::string const& goals, int crowd) {
    // No physics runs here: only the test moves objects.
    registerRuntime(registry_);
    registry_.property<Shape>();
    registry_.property<Fixed>();
    registry_.property<Conductor>();
    registry_.property<ElectricalDevice>();
    registerMaterial(registry_);
    PartLibrary library;
    library.add(readPart(registry_, JsonDocument::parse(R"({"name": "iron ball", "properties": {
        "shape": [{"form": "circle"}]}})",
                                                        "part.json")));
    std::string const lamp = R"({"conductor": true, "electrical_device": true, "material": "glass"})";
    library.add(
        readPart(registry_,
                 JsonDocument::parse(R"({"name": "night light", "properties": )" + lamp + "}", "part.json")));
    library.add(
        readPart(registry_, JsonDocument::parse(R"({"name": "desk lamp", "properties": {"conductor": true}})",
                                                "part.json")));
    std::string const shape = R"("shape": [{"form": "box"}])";
    std::string more;
    for (int i = 1; i <= crowd; ++i) {
        more += R"({"name": "one of many )" + std::to_string(i) + R"(", "at": [0, 9], "properties": {)" +
                shape + "}},";
    }
    std::string const text = R"({"version": 2, "title": "stage", "objects": [)" + more + R"(
        {"name": "floor", "at": [0, -1], "properties": {"fixed": true, )" +
                             shape + R"(}},
        {"name": "electromagnet", "at": [0, 3], "properties": {"fixed": true, "conductor": true, )" +
                             shape + R"(}},
        {"name": "metal object", "at": [0, 0], "properties": {)" +
                             shape + R"(}},
        {"name": "crate", "at": [5, 0], "properties": {)" +
                             shape + R"(}},
        {"name": "object 1", "at": [4, 0], "properties": {)" +
                             shape + R"(}},
        {"name": "idea"},
        {"name": "lamp", "at": [1, 0], "properties": )" +
                             lamp + R"(},
        {"name": "lantern", "at": [1, 1], "properties": )" +
                             lamp + R"(},
        {"name": "toy lamp", "at": [1, 2], "properties": {"conductor": true}},
        {"name": "lamp 2", "at": [2, 0], "properties": {"conductor": true}},
        {"name": "ball a", "part": "iron ball", "at": [7, 0]},
        {"name": "ball b", "part": "iron ball", "at": [8, 0]}],
        "toolbox": [{"part": "night light", "count": 1}, {"part": "desk lamp", "count": 1}],
        "goals": )" + goals + "}";
    level_ = readLevel(registry_, JsonDocument::parse(text, "level.json"));
    world_ = buildWorld(registry_, level_, library);
    judge_ = std::make_unique<GoalJudge>(level_, *world_);
}

ObjectId GoalStage::id(std::string const& name) const {
    ObjectId const id = world_->store().find(name);
    if (!id.valid()) {
        throw std::invalid_argument("no object " + name);
    }
    return id;
}

std::string GoalStage::met() const {
    std::string bits;
    for (GoalStatus const& goal : judge_->status()) {
        bits += goal.met ? '1' : '0';
    }
    return bits;
}

void GoalStage::put(std::string const& name, Vec2 at) {
    world_->store().column<Position>().set(id(name), {at});
}

void GoalStage::touch(std::string const& a, std::string const& b, std::uint64_t event) {
    TouchingPair const pair{std::min(id(a), id(b)), std::max(id(a), id(b)), EventId{event}};
    contacts_.current.push_back(pair);
    contacts_.begun.push_back(pair);
    std::sort(contacts_.current.begin(), contacts_.current.end());
    std::sort(contacts_.begun.begin(), contacts_.begun.end());
}

void GoalStage::part(std::string const& a, std::string const& b, std::uint64_t event) {
    TouchingPair const pair{std::min(id(a), id(b)), std::max(id(a), id(b)), EventId{event}};
    std::erase(contacts_.current, pair);
    contacts_.ended.push_back(pair);
    std::sort(contacts_.ended.begin(), contacts_.ended.end());
}

void GoalStage::hit(std::string const& a, std::string const& b, std::uint64_t event) {
    contacts_.brief.push_back({std::min(id(a), id(b)), std::max(id(a), id(b)), EventId{event}});
    std::sort(contacts_.brief.begin(), contacts_.brief.end());
}

void GoalStage::turn(std::string const& name, bool on, std::uint64_t event) {
    ObjectId const object = id(name);
    if (state_.byIndex.size() <= object.index) {
        state_.byIndex.resize(object.index + std::size_t{1});
    }
    state_.byIndex[object.index] = {object, on, EventId{event}};
}

void GoalStage::step(int frames) {
    for (int i = 0; i < frames; ++i) {
        world_->step();
        write();
        judge_->update(*world_);
    }
}

void GoalStage::write() {
    world_->store().slot<Contacts>().value() = contacts_;
    world_->store().slot<ElectricalState>().value() = state_;
    contacts_.begun.clear();
    contacts_.ended.clear();
    contacts_.brief.clear();
}

void GoalStage::stepInParts(std::function<void(std::uint32_t part)> const& set) {
    Store& store = world_->store();
    ObjectId const known = store.find("world");
    store.column<FrameSettings>().set(known.valid() ? known : store.create("world"), {4});
    world_->step([&](World const& world) {
        set(world.moment().part);
        write();
        judge_->update(world);
    });
}

std::string refusalOf(std::string const& goals, int crowd) {
    try {
        GoalStage const stage(goals, crowd);
        return "";
    } catch (InputError const& error) {
        return error.what();
    }
}

testing::AssertionResult isRefused(std::string const& goals, std::string const& words, int crowd) {
    std::string const refusal = refusalOf(goals, crowd);
    if (refusal.find(words) != std::string::npos) {
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure()
           << goals << "\nis refused with \"" << refusal << "\", not with \"" << words << '"';
}

std::string wordsOf(std::string const& goals) {
    GoalStage const stage(goals);
    std::vector<GoalStatus> const& status = stage.judge().status();
    return status.size() == 1 ? status[0].text : std::to_string(status.size()) + " goals";
}

} // namespace trembler
