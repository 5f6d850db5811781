// A world with scripts that a test states as text.
#pragma once

#include "lua/attach/register.hpp"
#include "lua/attach/scripts_property.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace trembler::lua {

/// The game's data, with some scripts as a mod.
struct ScriptedGame {
    explicit ScriptedGame(std::vector<std::string> const& sources, Trust trust = Trust::untrusted) {
        registerEffects(registry);
        mods.emplace_back();
        mods.back().name = "test";
        Problems problems;
        int number = 0;
        for (std::string const& source : sources) {
            mods.back().interactions.push_back(
                readManifest(source, "script" + std::to_string(++number) + ".lua", problems));
            mods.back().interactions.back().trust = trust;
        }
        registerMods(registry, mods, log, problems);
        problems.throwIfAny();
    }
    /// The messages so far, a line each.
    std::string messages() const {
        std::string all;
        for (ScriptMessage const& message : log->take()) {
            all += (message.error ? "error: " : "") + message.text + "\n";
        }
        return all;
    }

    Registry registry;
    std::vector<Mod> mods;
    std::shared_ptr<ScriptLog> log = std::make_shared<ScriptLog>();
};

/// A box of one square metre and 1000 kg that floats in empty space, unless there is gravity.
inline ObjectId addBox(Store& store, std::string const& name, Vec2 at, Vec2 velocity = {}) {
    ObjectId const box = store.create(name);
    store.column<Position>().set(box, {at});
    store.column<Shape>().set(box, {{boxPiece(1, 1)}});
    store.column<Mass>().set(box, {1000});
    store.column<Velocity>().set(box, {velocity});
    return box;
}

inline ComponentStatus statusOf(World const& world, std::string_view name) {
    for (ComponentStatus const& status : world.status()) {
        if (status.info->text.name == name) {
            return status;
        }
    }
    return {};
}

} // namespace trembler::lua
