// Worlds with the mods that come with the program.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace trembler::lua {

inline std::filesystem::path bundledModFolder() {
    return std::filesystem::path(TREMBLER_SOURCE_DIR) / "mods";
}

inline std::vector<Mod> bundledMods(std::vector<std::string> const& names) {
    Problems problems;
    std::vector<Mod> mods =
        findMods(names, std::vector<std::filesystem::path>{bundledModFolder()}, "test", problems);
    problems.throwIfAny();
    return mods;
}

/// Reading all parts takes longer than most tests, so the data of the same mods are read once in a program.
/// What their scripts have said before is forgotten.
inline GameData const* gameWith(std::vector<std::string> const& names) {
    static std::map<std::vector<std::string>, std::unique_ptr<GameData const>> made;
    auto& data = made[names];
    if (data == nullptr) {
        data = std::make_unique<GameData const>(bundledMods(names));
    }
    (void)data->scriptLog->take();
    return data.get();
}

/// A started world of a level with those objects: entries of its lists as a level file states them.
inline std::unique_ptr<World> worldOf(GameData const& game, std::string const& objects,
                                      std::string const& gravity = "[0, 0]",
                                      std::string const& connections = {}, WorldOptions options = {}) {
    std::string mods;
    for (Mod const& mod : game.mods) {
        mods += fmt::format("{}\"{}\"", mods.empty() ? "" : ", ", mod.name);
    }
    std::string const text = fmt::format(
        R"({{"version": 2, "title": "test", "mods": [{}], "world": {{"gravity": {}, "air": {{"density": 0}}}}, "objects": [{}],
            "connections": [{}]}})",
        mods, gravity, objects, connections);
    LevelFile const level = readLevel(game.registry, JsonDocument::parse(text, "test.json"));
    return buildWorld(game.registry, level, game.parts, {}, std::move(options));
}

/// The errors of scripts since the last call, a line each.
inline std::string errorsOf(GameData const& game) {
    std::string all;
    for (ScriptMessage const& message : game.scriptLog->take()) {
        all += message.script + ": " + message.text + "\n";
    }
    return all;
}

/// A property of an object of that name; the object and the property must be there.
template <class P>
P const& of(World const& world, std::string const& name) {
    return *world.find<P>(world.store().find(name));
}

inline void stepFrames(World& world, int frames) {
    for (int frame = 0; frame < frames; ++frame) {
        world.step();
    }
}

} // namespace trembler::lua
