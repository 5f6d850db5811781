// A world with only electricity, whose calls and contacts a test scripts frame by frame.
#pragma once

#include "physics/dynamics/properties/contacts.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/electricity/register.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"

#include <memory>
#include <string>
#include <vector>

namespace trembler::test {

/// The calls that a test scripts for the interactions of one frame.
inline constexpr std::size_t scripts = 3;
/// Instead of a script: cuts a wire of the level, as scissors do.
inline constexpr std::size_t scissors = scripts;
struct Script {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Script", "test_script", "Calls that a test wants made.",
                                       PropertyPlace::hidden};
    struct Line {
        ObjectId a;
        ObjectId b;
        std::size_t script = 0; ///< the interaction of a CircuitWorld that makes the calls
        bool add = true;
    };
    std::vector<Line> lines;
    std::vector<ObjectId> destroys;
    std::vector<CreateObject> creates;
};

/// The calls that a test has the interactions hold.
struct Holding {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Holding", "test_holding", "Calls that a test wants held.",
                                       PropertyPlace::hidden};
    struct Connection {
        ObjectId a;
        ObjectId b;
        std::size_t script = 0;
    };
    struct Voltage {
        ObjectId object;
        double voltage = 0; ///< V
        std::size_t script = 0;
    };
    std::vector<Connection> connections;
    std::vector<Voltage> voltages;
};

/// The contacts that a test sets.
struct Touching {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Touching", "test_touching", "Pairs that a test wants to touch.",
                                       PropertyPlace::hidden};
    std::vector<TouchingPair> pairs; ///< ascending
};

struct CollisionRole {
    static constexpr std::string_view name = "Collisions";
    using Calls = CallList<>;
};

/// Replaces a rigid-body engine: provides the contacts, including C_N and C_P, that the test has set.
class ScriptedCollisions final
    : public Resolver<ScriptedCollisions, CollisionRole, Reads<Touching>, Writes<>, Provides<Contacts>> {
public:
    static constexpr ComponentText text{
        .name = "Collisions", .effect = "test", .level = "", .work = "As the test states."};
    using Activation = NeedsAll<Touching>;
    void advance(Access& access);
};

/// The value with which an ElectricityFromScript is registered.
struct ScriptNumber {
    ComponentText text;
    std::size_t number = 0;
};
/// Several interactions of one C++ type: each makes the calls of its own number.
class ElectricityFromScript final
    : public Interaction<ElectricityFromScript, ElectricityRole, Reads<Script, Holding>> {
public:
    using Activation = NeedsAll<Script>;
    static constexpr Coverage memory = leftOut("its number is its name's, and for the world's life");
    ElectricityFromScript(ComponentInfo const& info, ScriptNumber const& script)
        : Interaction(info), number_(script.number) {}
    void apply(Access& access);

private:
    std::size_t number_;
};
/// Registers them under the names "Electricity <- Script 1" and so on.
void registerScripts(Registry& registry);
/// The count of the caller of that name.
[[nodiscard]] std::int32_t countBy(CallerCounts const& counts, std::string_view name);
/// The count of that script.
[[nodiscard]] std::int32_t countBy(CallerCounts const& counts, std::size_t script);

class PopulationFromScript final : public Interaction<PopulationFromScript, PopulationRole, Reads<Script>> {
public:
    static constexpr ComponentText text{
        .name = "Population <- Script", .effect = "test", .level = "", .work = "As the test states."};
    using Activation = NeedsAll<Script>;
    void apply(Access& access);
};

class CircuitWorld {
public:
    explicit CircuitWorld(WorldOptions options = {});

    /// A conductor; `network` as in Conductor.
    ObjectId conductor(std::string const& name, std::string const& network = {});
    /// Conductors that are source and return of a network.
    ObjectId source(std::string const& name, std::string const& network = {});
    ObjectId returning(std::string const& name, std::string const& network = {});
    /// Initial wires between consecutive objects of each list, by name; unknown names become conductors.
    void wire(std::vector<std::vector<std::string>> const& paths);
    [[nodiscard]] ObjectId operator[](std::string const& name) { return world().store().find(name); }

    [[nodiscard]] World& world() { return *world_; }
    [[nodiscard]] Store& store() { return world_->store(); }
    void start() { world_->start(); }
    /// Makes calls in the next frame; computes two frames, after which they are carried out and the state is
    /// derived.
    void call(std::vector<Script::Line> lines, std::vector<ObjectId> destroys = {},
              std::vector<CreateObject> creates = {});
    /// Sets the calls that the interactions make in the next frame.
    void write(std::vector<Script::Line> lines, std::vector<ObjectId> destroys = {},
               std::vector<CreateObject> creates = {});
    /// Sets the calls that the interactions hold; computes two frames, after which they are carried out.
    void hold(Holding holding);
    void connect(std::string const& a, std::string const& b, std::size_t script = 0);
    /// Removes a connection of connect(), or, if there is none, cuts a wire of the level.
    void disconnect(std::string const& a, std::string const& b, std::size_t script = 0);
    /// Sets the contacts from the next frame on.
    void touch(std::vector<std::pair<std::string, std::string>> const& pairs);

    [[nodiscard]] bool isOn(ObjectId id) const;
    /// The names of all objects that are on, ascending.
    [[nodiscard]] std::vector<std::string> on() const;
    [[nodiscard]] ElectricalState const& state() const { return *world_->find<ElectricalState>(); }
    [[nodiscard]] ComponentStatus status(std::string_view componentName) const;

private:
    Registry registry_;
    std::unique_ptr<World> world_;
    ObjectId director_;
};

} // namespace trembler::test
