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

/// What a test wants interactions to call in a frame.
inline constexpr std::size_t scripts = 3;
/// In place of a script: cuts a wire of the level, as scissors do.
inline constexpr std::size_t scissors = scripts;
struct Script {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Script", "test_script", "Calls that a test wants made.",
                                       PropertyPlace::hidden};
    struct Line {
        ObjectId a;
        ObjectId b;
        std::size_t script = 0; ///< which of the interactions of a CircuitWorld calls
        bool add = true;
    };
    std::vector<Line> lines;
    std::vector<ObjectId> destroys;
    std::vector<CreateObject> creates;
};

/// Who touches whom, as a test has it.
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

/// Stands in for a rigid body engine: provides contacts, C_N and C_P included, as the test has written them
/// down.
class ScriptedCollisions final
    : public Resolver<ScriptedCollisions, CollisionRole, Reads<Touching>, Writes<>, Provides<Contacts>> {
public:
    static constexpr ComponentText text{
        .name = "Collisions", .effect = "test", .level = "", .work = "As told."};
    using Activation = NeedsAll<Touching>;
    void advance(Access& access);
};

/// What an ElectricityFromScript is registered with.
struct ScriptNumber {
    ComponentText text;
    std::size_t number = 0;
};
/// Several interactions of one C++ type: each makes the calls of its own number.
class ElectricityFromScript final
    : public Interaction<ElectricityFromScript, ElectricityRole, Reads<Script>> {
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
/// How often the caller of that name has added.
[[nodiscard]] std::int32_t countBy(CallerCounts const& counts, std::string_view name);
/// How often that script has.
[[nodiscard]] std::int32_t countBy(CallerCounts const& counts, std::size_t script);

class PopulationFromScript final : public Interaction<PopulationFromScript, PopulationRole, Reads<Script>> {
public:
    static constexpr ComponentText text{
        .name = "Population <- Script", .effect = "test", .level = "", .work = "As told."};
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
    /// Initial wires between consecutive objects of each list, by name; what is unknown becomes a conductor.
    void wire(std::vector<std::vector<std::string>> const& paths);
    [[nodiscard]] ObjectId operator[](std::string const& name) { return world().store().find(name); }

    [[nodiscard]] World& world() { return *world_; }
    [[nodiscard]] Store& store() { return world_->store(); }
    void start() { world_->start(); }
    /// Makes calls in the next frame; two frames pass, so that they have been carried out and all is derived.
    void call(std::vector<Script::Line> lines, std::vector<ObjectId> destroys = {},
              std::vector<CreateObject> creates = {});
    /// Writes down what the interactions are to call in the next frame.
    void write(std::vector<Script::Line> lines, std::vector<ObjectId> destroys = {},
               std::vector<CreateObject> creates = {});
    void connect(std::string const& a, std::string const& b, std::size_t script = 0);
    /// Takes back what connect() added, or cuts a wire of the level if there is no such thing.
    void disconnect(std::string const& a, std::string const& b, std::size_t script = 0);
    /// Who touches whom from the next frame on.
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
