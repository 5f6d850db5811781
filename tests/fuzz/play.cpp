#include "tests/fuzz/play.hpp"

#include "lua/attach/register.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace trembler::lua {
namespace {

constexpr char const* witnessName = "Frame <- Witness";
constexpr char const* witnessScript = R"(return interaction {
  name = "Frame <- Witness", calls = "Frame", reads = {}, once = true, restless = true,
  store = { script = { turns = 0 } },
  apply = function(world, params, out, store)
    store.script.turns = store.script.turns + 1
    log(store.script.turns)
  end,
})";

struct Scene {
    GameData game;
    LevelFile level;
};

Scene const& scene() {
    static std::unique_ptr<Scene const> const made = [] {
        auto all = std::make_unique<Scene>();
        all->level = loadLevel(all->game.registry,
                               std::filesystem::path(TREMBLER_SOURCE_DIR) / "tests/lua/reference/world.json");
        return all;
    }();
    return *made;
}

void requireNumbers(World const& world) {
    Store const& store = world.store();
    auto const finite = [](Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); };
    for (ObjectId const id : store.findColumn<Position>()->owners()) {
        require(finite(world.find<Position>(id)->value), "a position is no number");
    }
    if (auto const* const velocities = store.findColumn<Velocity>()) {
        for (ObjectId const id : velocities->owners()) {
            require(finite(velocities->find(id)->value), "a velocity is no number");
        }
    }
}

} // namespace

void require(bool holds, std::string_view what) {
    if (!holds) {
        throw std::logic_error(std::string(what));
    }
}

Played playScript(std::string const& source, int frames, int threads) {
    Played played;
    Problems problems;
    std::vector<Mod> mods(1);
    mods.front().name = "fuzz";
    mods.front().interactions.push_back(readManifest(source, "fuzz.lua", problems));
    if (problems.count() > 0) {
        return played;
    }
    mods.front().interactions.push_back(readManifest(witnessScript, "witness.lua", problems));
    Registry registry;
    registerEffects(registry);
    auto const log = std::make_shared<ScriptLog>();
    (void)registerMods(registry, mods, log, problems);
    if (problems.count() > 0) {
        return played;
    }
    played.accepted = true;
    WorldOptions options;
    options.threads = threads;
    options.rowsWorthThreads = 0;
    auto const world = buildWorld(registry, scene().level, scene().game.parts, {}, options);
    int witnessed = 0;
    for (int frame = 0; frame < frames; ++frame) {
        world->step();
        requireNumbers(*world);
        played.hashes.push_back(world->stateHash());
        for (ScriptMessage const& message : log->take()) {
            if (message.script == witnessName) {
                require(!message.error, "the other script is switched off");
                ++witnessed;
            } else {
                played.messages += fmt::format("{}: {}\n", message.frame, message.text);
            }
        }
    }
    require(witnessed >= frames, "the other script has missed a turn");
    return played;
}

void playTwice(std::string const& source, int frames) {
    Played const one = playScript(source, frames, 1);
    if (one.accepted) {
        Played const other = playScript(source, frames, 4);
        require(one.hashes == other.hashes, "the hashes depend on threads, or on the run");
        require(one.messages == other.messages, "what the script says depends on threads, or on the run");
    }
}

} // namespace trembler::lua
