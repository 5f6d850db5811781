// What an interaction costs that reads three properties of each object and adds one force: in C++, and in
// Lua. Prints ns per object and turn, and what one that sleeps adds to a frame.
#include "lua/attach/register.hpp"
#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace trembler {
namespace {

/// Stands in for the rigid bodies: moves everything in every frame, and forgets the forces.
struct Mover final : Resolver<Mover, DynamicsRole, Reads<>, Writes<Position>> {
    static constexpr ComponentText text{
        .name = "Mover", .effect = "bench", .level = "", .work = "Marks positions as changed."};
    using Activation = NeedsAll<Position>;
    [[nodiscard]] bool restless() const { return true; }
    void advance(Access& access) { (void)access.write<Position>(); }
};

struct Native final : Interaction<Native, DynamicsRole, Reads<Position, Velocity, Mass>> {
    static constexpr ComponentText text{
        .name = "Dynamics <- Native", .effect = "bench", .level = "", .work = "Adds a force."};
    using Activation = NeedsAll<Mass>;
    void apply(Access& access) {
        forEach(
            [&](ObjectId id, Position const& position, Velocity const& velocity, Mass const& mass) {
                access.call(AddForce{id, {mass.value * (10 - velocity.value.x), -position.value.y}});
            },
            access.read<Position>(), access.read<Velocity>(), access.read<Mass>());
    }
};
std::string const awake = R"(return interaction {
  name = "Dynamics <- Script", calls = "Dynamics", reads = { "Position", "Velocity", "Mass" }, each = { "Mass" },
  apply = function(object, params, out)
    out.addForce(object, vec2(object.Mass.value * (10 - object.Velocity.value.x), -object.Position.value.y))
  end,
})";
std::string const asleep = R"(return interaction {
  name = "Dynamics <- Sleeping script", calls = "Dynamics", reads = { "Mass" }, each = { "Mass" },
  apply = function(object, params, out) end,
})";

lua::Mod modOf(std::vector<std::string> const& sources) {
    lua::Mod mod;
    mod.name = "bench";
    Problems problems;
    for (std::string const& source : sources) {
        mod.interactions.push_back(lua::readManifest(source, "bench.lua", problems));
    }
    problems.throwIfAny();
    return mod;
}

std::unique_ptr<World> worldOf(Registry const& registry, int objects) {
    auto world = std::make_unique<World>(registry);
    Store& store = world->store();
    std::vector<ObjectId> ids;
    for (int i = 0; i < objects; ++i) {
        ids.push_back(store.create(fmt::format("object {}", i)));
    }
    auto const count = ids.size();
    store.column<Position>().addMany(ids, std::vector<Position>(count, Position{{1, 2}}));
    store.column<Velocity>().addMany(ids, std::vector<Velocity>(count, Velocity{{3, 4}}));
    store.column<Mass>().addMany(ids, std::vector<Mass>(count, Mass{5}));
    world->start();
    return world;
}

// The least of several frames, as other work on the machine can only add to it.
double nsPerObject(World& world, std::string_view name, int objects, int frames) {
    double least = 1e300;
    for (int i = 0; i < frames; ++i) {
        world.step();
        for (ComponentStatus const& status : world.status()) {
            if (status.info->text.name == name) {
                least = std::min(least, status.lastMicroseconds);
            }
        }
    }
    return 1000 * least / objects;
}

double nsPerFrame(World& world, int frames) {
    double least = 1e300;
    for (int round = 0; round < 20; ++round) {
        auto const before = std::chrono::steady_clock::now();
        for (int i = 0; i < frames; ++i) {
            world.step();
        }
        std::chrono::duration<double, std::nano> const took = std::chrono::steady_clock::now() - before;
        least = std::min(least, took.count() / frames);
    }
    return least;
}

int measure() {
    auto const log = std::make_shared<lua::ScriptLog>();
    auto const registryOf = [&](bool native, std::vector<std::string> const& sources) {
        auto registry = std::make_unique<Registry>();
        registry->component<Mover>();
        registry->property<Velocity>();
        registry->property<Mass>();
        if (native) {
            registry->component<Native>();
        }
        Problems problems;
        if (!sources.empty()) {
            lua::registerMods(*registry, std::vector<lua::Mod>{modOf(sources)}, log, problems);
        }
        problems.throwIfAny();
        return registry;
    };
    fmt::print("{:>10} {:>12} {:>12} {:>8}\n", "objects", "native (ns)", "script (ns)", "ratio");
    for (int const objects : {1000, 100'000}) {
        int const frames = objects > 10'000 ? 20 : 500;
        auto const registry = registryOf(true, {awake});
        auto const world = worldOf(*registry, objects);
        double const native = nsPerObject(*world, "Dynamics <- Native", objects, frames);
        double const script = nsPerObject(*world, "Dynamics <- Script", objects, frames);
        fmt::print("{:>10} {:>12.1f} {:>12.1f} {:>8.1f}\n", objects, native, script, script / native);
    }
    // Many of the same, as one is less than the clock tells.
    constexpr int sleepers = 50;
    std::vector<std::string> many;
    for (int i = 0; i < sleepers; ++i) {
        std::string source = asleep;
        source.replace(source.find("Sleeping script"), 15, fmt::format("Sleeper {}", i));
        many.push_back(source);
    }
    auto const none = registryOf(false, {});
    auto const with = registryOf(false, many);
    auto const plainWorld = worldOf(*none, 100);
    auto const fullWorld = worldOf(*with, 100);
    fullWorld->step();
    double const plain = nsPerFrame(*plainWorld, 1000);
    double const full = nsPerFrame(*fullWorld, 1000);
    fmt::print("a script that sleeps: {:.1f} ns a frame\n", (full - plain) / sleepers);
    for (lua::ScriptMessage const& message : log->take()) {
        fmt::print("{}: {}\n", message.script, message.text);
    }
    return 0;
}

} // namespace
} // namespace trembler

int main() {
    return trembler::measure();
}
