// The cost of an interaction that reads three properties of each object and adds one force: in C++, in
// trusted Lua and in untrusted Lua. Prints ns per object and turn, the time that a sleeping interaction adds
// to a frame, and the time that one whose properties no object has adds to it. All worlds run in one process,
// in turns, so that other work on the machine affects all of them equally.
#include "bench/measure.hpp"
#include "lua/attach/register.hpp"
#include "physics/dynamics/calls.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
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

struct SleeperKind {
    ComponentText text;
};
struct NativeSleeper final : Interaction<NativeSleeper, DynamicsRole, Reads<Mass>> {
    using Activation = NeedsAll<Mass>;
    NativeSleeper(ComponentInfo const& info, SleeperKind const&) : Interaction(info) {}
    void apply(Access&) {}
};

struct NativeAbsent final : Interaction<NativeAbsent, DynamicsRole, Reads<Mass, Density>> {
    using Activation = NeedsAll<Density>;
    NativeAbsent(ComponentInfo const& info, SleeperKind const&) : Interaction(info) {}
    void apply(Access&) {}
};

std::string scriptOf(std::string const& name, std::string const& each, std::string const& body) {
    return "return interaction {\n  name = \"Dynamics <- " + name +
           "\", calls = \"Dynamics\", reads = { \"Position\", \"Velocity\", \"Mass\" }, each = { \"" + each +
           "\" },\n  apply = function(object, params, out)\n" + body + "\n  end,\n}\n";
}
std::string const numbers = "out.addForce(object, object.Mass.value * (10 - object.Velocity.value.x), "
                            "-object.Position.value.y)";
std::string const vectors = "out.addForce(object, vec2(object.Mass.value * (10 - object.Velocity.value.x), "
                            "-object.Position.value.y))";
// The host cannot pass this vector as two numbers: see spreadVectors().
std::string const madeFirst = "local force = vec2(object.Mass.value * (10 - object.Velocity.value.x), "
                              "-object.Position.value.y) out.addForce(object, force)";

void add(lua::Mod& mod, std::string const& source, lua::Trust trust) {
    Problems problems;
    mod.interactions.push_back(lua::readManifest(source, "bench.lua", problems));
    problems.throwIfAny();
    mod.interactions.back().trust = trust;
}

struct Game {
    Registry registry;
    std::vector<lua::Mod> mods = std::vector<lua::Mod>(1);
    std::shared_ptr<lua::ScriptLog> log = std::make_shared<lua::ScriptLog>();

    Game() {
        registry.component<Mover>();
        registry.property<Velocity>();
        registry.property<Mass>();
        registry.property<Density>();
        mods.front().name = "bench";
    }
    void registerScripts() {
        Problems problems;
        lua::registerMods(registry, mods, log, problems);
        problems.throwIfAny();
    }
    void tell() const {
        for (lua::ScriptMessage const& message : log->take()) {
            fmt::print("{}: {}\n", message.script, message.text);
        }
    }
};

std::unique_ptr<World> worldOf(Registry const& registry, int objects) {
    auto world = std::make_unique<World>(registry);
    Store& store = world->store();
    std::vector<ObjectId> ids;
    std::vector<Position> positions;
    std::vector<Velocity> velocities;
    std::vector<Mass> masses;
    for (int i = 0; i < objects; ++i) {
        ids.push_back(store.create(fmt::format("object {}", i)));
        positions.push_back(Position{{1.0 + i, 2.0 - i}});
        velocities.push_back(Velocity{{3.0 + 0.1 * i, 4.0}});
        masses.push_back(Mass{5.0 + 0.01 * i});
    }
    store.column<Position>().addMany(ids, positions);
    store.column<Velocity>().addMany(ids, velocities);
    store.column<Mass>().addMany(ids, masses);
    world->start();
    return world;
}

/// Processor time of the calling thread, s: other programs' time does not count. The worlds have one thread.
double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
/// Processor time of a frame of each world, in s, measured in turns.
template <std::size_t N>
std::array<bench::Series, N> timesOf(std::array<Game, N>& games, int objects, int frames, int rounds) {
    std::vector<std::unique_ptr<World>> worlds;
    for (Game& game : games) {
        game.registerScripts();
        worlds.push_back(worldOf(game.registry, objects));
        for (int i = 0; i < 10; ++i) { // the code is compiled meanwhile
            worlds.back()->step();
        }
    }
    std::array<bench::Series, N> took;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < worlds.size(); ++i) {
            double const before = processorTime();
            for (int frame = 0; frame < frames; ++frame) {
                worlds[i]->step();
            }
            took[i].add((processorTime() - before) / frames);
        }
    }
    for (Game const& game : games) {
        game.tell();
    }
    return took;
}

void measureObjects(int objects, int frames, int rounds) {
    struct Kind {
        std::string name;
        lua::Trust trust;
        std::string body;
    };
    std::array<Kind, 5> const kinds{Kind{"Trusted, numbers", lua::Trust::trusted, numbers},
                                    Kind{"Trusted, vectors", lua::Trust::trusted, vectors},
                                    Kind{"Untrusted, numbers", lua::Trust::untrusted, numbers},
                                    Kind{"Untrusted, vectors", lua::Trust::untrusted, vectors},
                                    Kind{"Untrusted, made first", lua::Trust::untrusted, madeFirst}};
    std::array<Game, 7> games; // none, native, scripts
    games[1].registry.component<Native>();
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        add(games[k + 2].mods.front(), scriptOf(kinds[k].name, "Mass", kinds[k].body), kinds[k].trust);
    }
    auto const took = timesOf(games, objects, frames, rounds);
    auto const each = [&](std::size_t i) { return (took[i].median() - took[0].median()) * 1e9 / objects; };
    bench::Table table(fmt::format("{} objects: three properties read, one force added", objects));
    double const native = each(1);
    table.row("native", native, "ns per object");
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        double const script = each(k + 2);
        table.row(kinds[k].name, script, "ns per object", script / native,
                  kinds[k].trust == lua::Trust::trusted ? 3 : 60);
    }
    table.print();
}

// Many of the same kind, as one takes less than the clock's resolution.
constexpr int sleepers = 50;

void measureSleepers() {
    std::vector<std::string> names;
    for (int i = 0; i < sleepers; ++i) {
        names.push_back(fmt::format("Dynamics <- Native sleeper {}", i));
    }
    std::vector<SleeperKind> natives;
    for (std::string const& name : names) {
        natives.push_back({{.name = name, .effect = "bench", .level = "", .work = "Sleeps."}});
    }
    // None, native, scripts; then interactions whose properties no object has: native, scripts.
    std::array<Game, 5> games;
    for (SleeperKind const& kind : natives) {
        games[1].registry.component<NativeSleeper>(kind);
        games[3].registry.component<NativeAbsent>(kind);
    }
    for (int i = 0; i < sleepers; ++i) {
        std::string const asleep =
            "return interaction { name = \"Dynamics <- Sleeper " + std::to_string(i) +
            "\", calls = \"Dynamics\", reads = { \"Mass\" }, each = { \"Mass\" }, apply = "
            "function(object, params, out) end }";
        add(games[2].mods.front(), asleep, lua::Trust::untrusted);
        add(games[4].mods.front(), scriptOf(fmt::format("Absent {}", i), "Density", "error('never')"),
            lua::Trust::untrusted);
    }
    auto const took = timesOf(games, 100, 1000, 60);
    auto const each = [&](std::size_t i) { return (took[i].median() - took[0].median()) * 1e9 / sleepers; };
    bench::Table table(fmt::format("{} interactions that have nothing to do", sleepers));
    table.row("native, asleep", each(1), "ns a frame, each");
    table.row("script, asleep", each(2), "ns a frame, each", each(2), std::max(10.0, 1.5 * each(1)));
    table.row("native, no object calls for it", each(3), "ns a frame, each");
    table.row("script, no object calls for it", each(4), "ns a frame, each", each(4),
              std::max(1.0, 1.5 * each(3)));
    table.print();
}

} // namespace
} // namespace trembler

int main() {
    trembler::measureObjects(1000, 20, 60);
    trembler::measureObjects(100'000, 1, 30);
    trembler::measureSleepers();
    return 0;
}
