// The level of free play: the same at each opening, with room where players of earlier versions have built.
#include "physics/electricity/properties/electrical.hpp"
#include "puzzle/campaign/free_play.hpp"
#include "puzzle/campaign/kept_builds.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace trembler {
namespace free_play_test {
namespace {

std::string freeText() {
    return freePlayLevel(gameData().parts, "Free", "Build.");
}
LevelFile freeLevel() {
    return readLevel(gameData().registry, JsonDocument::parse(freeText(), "free-play.json"));
}

TEST(FreePlayLevel, IsTheSameEachTime) {
    EXPECT_EQ(freeText(), freeText());
    Session one(gameData().registry, gameData().parts, freeLevel());
    WorldOptions several;
    several.threads = 3;
    Session other(gameData().registry, gameData().parts, freeLevel(), several);
    for (Session* const session : {&one, &other}) {
        ASSERT_TRUE(session->place({"iron ball", {6.9, 1}, 0, ""}));
        ASSERT_TRUE(session->place({"cork", {6.5, 2}, 0, ""}));
        ASSERT_TRUE(session->place({"cart", {0, 1}, 0, ""}));
        for (int i = 0; i < 180; ++i) {
            session->step();
        }
    }
    EXPECT_EQ(one.world().stateHash(), other.world().stateHash());
}

TEST(FreePlayLevel, OffersEveryPartAndWiresWithoutALimit) {
    LevelFile const free = freeLevel();
    EXPECT_EQ(free.wires, unlimitedCount);
    ASSERT_EQ(free.toolbox.size(), gameData().parts.names().size());
    for (ToolboxEntry const& entry : free.toolbox) {
        EXPECT_EQ(entry.count, unlimitedCount) << entry.part;
    }
}

// The scenery of this version lies beside the room of the former one, in which nothing is in the way.
TEST(FreePlayLevel, HasTheRoomOfEarlierVersions) {
    Session session(gameData().registry, gameData().parts, freeLevel());
    for (int column = 0; column <= 11; ++column) {
        for (int row = 0; row <= 5; ++row) {
            Vec2 const at{-5.5 + column, 0.3 + row * 1.06};
            EXPECT_TRUE(session.check({"iron ball", at, 0, ""}).ok)
                << at.x << ", " << at.y << ": " << session.check({"iron ball", at, 0, ""}).why;
        }
    }
}

TEST(FreePlayLevel, LoadsABuildOfAnEarlierVersion) {
    auto const folder = std::filesystem::path(TREMBLER_BINARY_DIR) / "free-play-builds";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    KeptBuilds builds(folder);
    std::ofstream(builds.fileOf("free-play.json")) << R"({"name": "my build", "placements": [
        {"part": "battery", "at": [-5.5, 0.12]}, {"part": "lamp", "at": [5.6, 5.4], "angle_deg": 90},
        {"part": "iron ball", "at": [0, 5.8]}, {"part": "wire", "at": [-5.8, 3]}, {"part": "wall", "at": [5.8, 0]}]})";
    Session session(gameData().registry, gameData().parts, freeLevel());
    EXPECT_EQ(builds.restore("free-play.json", session), 0);
    EXPECT_EQ(session.placed().size(), 5U);
}

TEST(FreePlayLevel, ABatteryAndTwoWiresLightALampAndAreKept) {
    auto const folder = std::filesystem::path(TREMBLER_BINARY_DIR) / "free-play-wires";
    std::filesystem::remove_all(folder);
    KeptBuilds builds(folder);
    auto const lit = [](Session& session) {
        session.start();
        for (int i = 0; i < 10; ++i) {
            session.step();
        }
        auto const* const state = session.world().find<ElectricalState>();
        bool const on = state != nullptr && state->isOn(session.world().store().find("lamp 1"));
        session.stop();
        return on;
    };
    {
        Session session(gameData().registry, gameData().parts, freeLevel());
        ASSERT_TRUE(session.place({"battery", {-1, 0.2}, 0, ""}));
        ASSERT_TRUE(session.place({"lamp", {1, 1.5}, 0, ""}));
        EXPECT_FALSE(lit(session));
        auto const find = [&](char const* name) { return session.world().store().find(name); };
        ASSERT_TRUE(session.layWire(find("battery 1 plus"), find("lamp 1")));
        EXPECT_FALSE(lit(session));
        ASSERT_TRUE(session.layWire(find("battery 1 minus"), find("lamp 1")));
        EXPECT_TRUE(lit(session));
        BuildKeeper keeper(builds, "free-play.json");
        keeper.finish(session);
        EXPECT_FALSE(builds.unwritten());
    }
    Session session(gameData().registry, gameData().parts, freeLevel());
    BuildKeeper keeper(builds, "free-play.json");
    EXPECT_EQ(keeper.restore(session), 0);
    EXPECT_EQ(session.wires().size(), 2U);
    EXPECT_TRUE(lit(session));
    ASSERT_TRUE(session.takeWire(session.find(session.wires()[0].a), session.find(session.wires()[0].b)));
    EXPECT_FALSE(lit(session));
    ASSERT_TRUE(session.undo());
    EXPECT_TRUE(lit(session));
}

} // namespace
} // namespace free_play_test
} // namespace trembler
