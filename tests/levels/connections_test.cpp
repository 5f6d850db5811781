// Electric wires beside another effect's pipes in one level: each connection goes to the effect that owns it.
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "physics/register_physics.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/write/schema.hpp"
#include "tests/levels/schema_validator.hpp"
#include "tests/runtime/level/plumbing.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace connections_test {
namespace {

using plumbing::Vessel;

Registry const& registry() {
    static Registry const shared = [] {
        Registry made;
        registerEverything(made);
        plumbing::fill(made);
        return made;
    }();
    return shared;
}

/// A battery and a lamp, a tank and a tap, two copper kettles that can have wires and pipes, and a plank that
/// can have neither.
std::string levelWith(std::string const& connections) {
    return R"({"version": 2, "title": "plumbing", "objects": [
        {"name": "battery", "properties": {"conductor": true, "electrical_source": true}},
        {"name": "lamp", "properties": {"conductor": true}},
        {"name": "tank", "properties": {"test_vessel": 100}}, {"name": "tap", "properties": {"test_vessel": 1}},
        {"name": "kettle", "properties": {"conductor": true, "test_vessel": 2}},
        {"name": "pot", "properties": {"conductor": true, "test_vessel": 2}}, {"name": "plank"}],
        "connections": [)" +
           connections + "]}";
}

std::unique_ptr<World> build(std::string const& connections) {
    PartLibrary const none;
    return buildWorld(registry(),
                      readLevel(registry(), JsonDocument::parse(levelWith(connections), "p.json")), none);
}

std::string problemOf(std::string const& connections) {
    return plumbing::problemOf([&] { (void)build(connections); });
}

bool wired(World const& world, std::string const& a, std::string const& b) {
    Store const& store = world.store();
    return connectionBetween(store, store.find(a), store.find(b)).any();
}
bool piped(World const& world, std::string const& a, std::string const& b) {
    Vessel const* const vessel = world.find<Vessel>(world.store().find(a));
    return vessel != nullptr && vessel->to == std::vector{world.store().find(b)};
}

TEST(Connections, BelongToTheEffectThatCanConnectTheTwo) {
    auto const world =
        build(R"(["battery", "lamp"], ["tank", "tap"], ["kettle", "lamp"], ["kettle", "tank"])");
    EXPECT_TRUE(wired(*world, "battery", "lamp"));
    EXPECT_TRUE(wired(*world, "kettle", "lamp"));
    EXPECT_FALSE(wired(*world, "kettle", "tank"));
    EXPECT_TRUE(piped(*world, "tank", "tap"));
    EXPECT_TRUE(piped(*world, "kettle", "tank"));
}

TEST(Connections, BelongToTheStatedEffectIfSeveralCould) {
    std::string const refused = problemOf(R"(["kettle", "pot"])");
    EXPECT_NE(refused.find("/connections/0: 'kettle' and 'pot' can be connected in more than one way"),
              std::string::npos)
        << refused;
    EXPECT_NE(refused.find("'pipe' or 'wire'"), std::string::npos) << refused;
    auto const wire = build(R"({"between": ["kettle", "pot"], "kind": "wire"})");
    EXPECT_TRUE(wired(*wire, "kettle", "pot"));
    EXPECT_FALSE(piped(*wire, "kettle", "pot"));
    auto const pipe = build(R"({"between": ["kettle", "pot"], "kind": "pipe"})");
    EXPECT_FALSE(wired(*pipe, "kettle", "pot"));
    EXPECT_TRUE(piped(*pipe, "kettle", "pot"));
}

TEST(Connections, ThatNoEffectCanMakeAreReportedWithAReasonForEachKind) {
    std::string const refused = problemOf(R"(["battery", "plank"])");
    for (char const* words : {"nothing can connect 'battery' and 'plank'", "no wire: 'plank' is no conductor",
                              "no pipe: 'battery' holds no liquid"}) {
        EXPECT_NE(refused.find(words), std::string::npos) << words << " is missing in " << refused;
    }
    std::string const wrong = problemOf(R"({"between": ["tank", "tap"], "kind": "wire"})");
    EXPECT_NE(wrong.find("/connections/0: 'tank' is no conductor"), std::string::npos) << wrong;
}

TEST(Connections, TheSchemaHasBothFormsAndAllKinds) {
    nlohmann::json const schema = levelSchema(registry(), {});
    auto const faults = [&](std::string const& connection) {
        return validate(schema, nlohmann::json::parse(levelWith(connection)));
    };
    EXPECT_TRUE(faults(R"(["battery", "lamp"])").empty());
    EXPECT_TRUE(faults(R"({"between": ["kettle", "pot"], "kind": "pipe"})").empty());
    EXPECT_TRUE(faults(R"({"between": ["kettle", "pot"], "kind": "wire"})").empty());
    EXPECT_FALSE(faults(R"({"between": ["kettle", "pot"], "kind": "belt"})").empty());
    EXPECT_FALSE(faults(R"({"between": ["kettle", "pot"]})").empty());
    EXPECT_FALSE(faults(R"({"between": ["kettle"], "kind": "pipe"})").empty());
    EXPECT_FALSE(faults(R"({"between": ["kettle", "pot"], "kind": "pipe", "bore": 1})").empty());
}

// A registry without electricity still recognises wires.
TEST(Connections, OfAnEffectThatIsLeftOutStillBelongToIt) {
    Registry without;
    registerEverything(without, {"electricity"});
    plumbing::fill(without);
    PartLibrary const none;
    auto const world =
        buildWorld(without,
                   readLevel(without, JsonDocument::parse(levelWith(R"(["battery", "lamp"], ["tank", "tap"],
                                                       {"between": ["kettle", "pot"], "kind": "wire"})"),
                                                          "p.json")),
                   none);
    EXPECT_TRUE(piped(*world, "tank", "tap"));
    EXPECT_FALSE(piped(*world, "kettle", "pot"));
}

} // namespace
} // namespace connections_test
} // namespace trembler
