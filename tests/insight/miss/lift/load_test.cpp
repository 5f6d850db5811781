#include "insight/miss/lift/load.hpp"
#include "physics/depth.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace trembler::insight {
namespace load_test {
namespace {

/// A raft of two boards welded together at rest on a fixed floor; a crate on one of them, a ball on the
/// crate, a crate beside the raft, and a bob that hangs on the raft by a hinge.
std::unique_ptr<World> raftWorld() {
    auto const box = [](char const* name, double x, double y, double width, bool fixed) {
        nlohmann::json properties{{"shape", {{{"form", "box"}, {"width", width}, {"height", 0.2}}}},
                                  {"density", 1000}};
        if (fixed) {
            properties["fixed"] = true;
        }
        return nlohmann::json{{"name", name}, {"at", {x, y}}, {"properties", properties}};
    };
    nlohmann::json const level{
        {"version", 2},
        {"title", "Raft"},
        {"world", {{"gravity", {0, -9.81}}}},
        {"objects",
         {box("floor", 0, -0.1, 20, true), box("left board", -0.5, 0.1, 1, false),
          box("right board", 0.5, 0.1, 1, false), box("crate", -0.5, 0.3, 0.2, false),
          box("box", -0.5, 0.5, 0.2, false), box("beside", 3, 0.1, 0.2, false),
          box("bob", 1.5, 0.1, 0.2, false)}},
        {"joints",
         {{{"name", "weld"}, {"form", "weld"}, {"a", "left board"}, {"b", "right board"}, {"at", {0, 0.1}}},
          {{"name", "hinge"}, {"form", "hinge"}, {"a", "right board"}, {"b", "bob"}, {"at", {1.2, 0.1}}}}}};
    auto world = buildWorld(gameData().registry,
                            readLevel(gameData().registry, JsonDocument::parse(level.dump(), "raft.json")),
                            gameData().parts);
    for (int frame = 0; frame < 10; ++frame) { // for contacts and weights
        world->step();
    }
    return world;
}

std::vector<std::string> namesOf(World const& world, std::vector<load::Body> const& bodies) {
    std::vector<std::string> names;
    for (load::Body const& body : bodies) {
        names.push_back(world.store().nameOf(body.id));
    }
    std::sort(names.begin(), names.end());
    return names;
}

TEST(Load, IsWhatLiesOnAGroupDirectlyOrNot) {
    std::unique_ptr<World const> const world = raftWorld();
    load::Neighbours const neighbours(*world);
    load::Group const raft = groupOf(*world, neighbours, world->store().find("left board"));
    EXPECT_EQ(namesOf(*world, raft.bodies), (std::vector<std::string>{"bob", "left board", "right board"}));
    EXPECT_FALSE(raft.welded) << "the bob turns";
    EXPECT_EQ(namesOf(*world, carriedBy(*world, neighbours, raft.bodies, {0, 1})),
              (std::vector<std::string>{"box", "crate"}));
    EXPECT_TRUE(carriedBy(*world, neighbours, raft.bodies, {0, -1}).empty()) << "the floor is no load";
    EXPECT_NEAR(widthOf(raft.bodies, {0, 1}), 2.6, 0.02) << "from -1 m to 1.6 m";
}

TEST(Load, OfALooseBodyIsItsOwn) {
    std::unique_ptr<World const> const world = raftWorld();
    load::Neighbours const neighbours(*world);
    load::Group const alone = groupOf(*world, neighbours, world->store().find("beside"));
    EXPECT_EQ(namesOf(*world, alone.bodies), std::vector<std::string>{"beside"});
    EXPECT_TRUE(alone.welded);
    EXPECT_NEAR(alone.bodies.front().weight.y, -9.81 * 1000 * 0.2 * 0.2 * worldDepth, 1e-6);
    EXPECT_TRUE(carriedBy(*world, neighbours, alone.bodies, {0, 1}).empty());
    EXPECT_TRUE(groupOf(*world, neighbours, world->store().find("floor")).bodies.empty()) << "it is fixed";
}

} // namespace
} // namespace load_test
} // namespace trembler::insight
