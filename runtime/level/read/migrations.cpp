#include "runtime/level/read/migrations.hpp"

#include <array>

namespace trembler {
namespace {

/// Version 0, the draft of the format, had the world's gravity at the top of the file and the toolbox as an
/// object {part: count}.
void fromDraft(nlohmann::json& document) {
    if (auto const gravity = document.find("gravity"); gravity != document.end()) {
        nlohmann::json value = *gravity;
        document.erase(gravity);
        nlohmann::json& world = document["world"];
        if (world.is_null()) {
            world = nlohmann::json::object();
        }
        if (world.is_object() && !world.contains("gravity")) {
            world["gravity"] = std::move(value);
        }
    }
    if (auto const toolbox = document.find("toolbox"); toolbox != document.end() && toolbox->is_object()) {
        nlohmann::json entries = nlohmann::json::array();
        for (auto const& [part, count] : toolbox->items()) {
            entries.push_back({{"part", part}, {"count", count}});
        }
        *toolbox = std::move(entries);
    }
}

/// In version 1 an object without a part stated its material in its look, and the material affected only its
/// sound.
void ownMaterial(nlohmann::json& properties, nlohmann::json material) {
    auto const unlessStated = [&](char const* key, nlohmann::json value) {
        if (!properties.contains(key)) {
            properties[key] = std::move(value);
        }
    };
    unlessStated("friction", 0.5);
    unlessStated("restitution", 0);
    unlessStated("conductor", false);
    unlessStated("magnetic_strength", false);
    bool const moves = properties.value("fixed", nlohmann::json()) != true;
    if ((moves || properties.contains("liquid")) && !properties.contains("mass")) {
        unlessStated("density", 1000);
    }
    unlessStated("material", std::move(material));
}

/// Version 1 had the material in the look, and numbers that did not depend on it. These numbers are now
/// stated, so that all motion stays the same. An object made from a part keeps the part's material and only
/// its look differs.
void fromLooks(nlohmann::json& document) {
    auto const objects = document.find("objects");
    if (objects == document.end() || !objects->is_array()) {
        return;
    }
    for (nlohmann::json& object : *objects) {
        if (!object.is_object() || !object.contains("properties") || !object["properties"].is_object()) {
            continue;
        }
        nlohmann::json& properties = object["properties"];
        auto const look = properties.find("look");
        if (look == properties.end() || !look->is_object() || !look->contains("material")) {
            continue;
        }
        nlohmann::json material = (*look)["material"];
        look->erase("material");
        if (object.contains("part")) {
            (*look)["pattern"] = std::move(material);
            continue;
        }
        if (look->empty()) {
            properties.erase(look);
        }
        ownMaterial(properties, std::move(material));
    }
}

constexpr std::array<LevelMigration, 2> steps{{{0, fromDraft}, {1, fromLooks}}};

} // namespace

std::span<LevelMigration const> levelMigrations() {
    return steps;
}

void migrate(nlohmann::json& document, int version) {
    for (LevelMigration const& migration : levelMigrations()) {
        if (migration.from >= version) {
            migration.step(document);
        }
    }
}

} // namespace trembler
