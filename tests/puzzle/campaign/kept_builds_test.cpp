// The parts that a player placed are restored; and the level of free play.
#include "puzzle/campaign/free_play.hpp"
#include "puzzle/campaign/kept_builds.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace trembler {
namespace {

namespace fs = std::filesystem;

class KeptBuild : public testing::Test {
protected:
    KeptBuild() { fs::remove_all(folder); }

    [[nodiscard]] static LevelFile level() {
        return loadLevel(gameData().registry,
                         fs::path(TREMBLER_SOURCE_DIR) / "levels/first/1-first-contact.json");
    }

    fs::path const folder = fs::path(TREMBLER_BINARY_DIR) / "kept-builds" /
                            testing::UnitTest::GetInstance()->current_test_info()->name();
    KeptBuilds builds{folder};
};

TEST_F(KeptBuild, IsThereAgainInTheNextSession) {
    Placement const bar{"steel bar", {-1.8, 1.3}, 0.1, ""};
    {
        Session session(gameData().registry, gameData().parts, level());
        BuildKeeper keeper(builds, "first/1");
        EXPECT_EQ(keeper.restore(session), 0);
        ASSERT_TRUE(session.place(bar));
        keeper.pass(session, 0.1);
        EXPECT_FALSE(fs::exists(builds.fileOf("first/1"))) << "not yet";
        keeper.pass(session, BuildKeeper::delay);
        EXPECT_TRUE(fs::exists(builds.fileOf("first/1")));
        auto const written = fs::last_write_time(builds.fileOf("first/1"));
        session.start();
        session.step();
        keeper.finish(session);
        EXPECT_EQ(fs::last_write_time(builds.fileOf("first/1")), written) << "a run changes nothing of it";
        EXPECT_FALSE(builds.unwritten());
    }
    Session session(gameData().registry, gameData().parts, level());
    BuildKeeper keeper(builds, "first/1");
    EXPECT_EQ(keeper.restore(session), 0);
    ASSERT_EQ(session.placed().size(), 1U);
    EXPECT_EQ(session.placed()[0].placement.at, bar.at);
    EXPECT_NEAR(session.placed()[0].placement.angle, bar.angle, 1e-12);
    EXPECT_EQ(session.mode(), SessionMode::building);
    session.putAllBack();
    keeper.finish(session);
    EXPECT_FALSE(fs::exists(builds.fileOf("first/1"))) << "nothing built, nothing kept";
}

TEST_F(KeptBuild, ThatCannotBeReadIsNamed) {
    fs::create_directories(folder);
    ASSERT_EQ(::mkfifo(builds.fileOf("x").c_str(), 0600), 0);
    Session session(gameData().registry, gameData().parts, level());
    EXPECT_EQ(builds.restore("x", session), 0);
    std::vector<InputError> const notRead = builds.takeNotRead();
    ASSERT_EQ(notRead.size(), 1U);
    EXPECT_NE(std::string(notRead.front().what()).find(builds.fileOf("x").string() + ": is no ordinary file"),
              std::string::npos)
        << notRead.front().what();
    EXPECT_TRUE(builds.takeNotRead().empty()) << "once";
    EXPECT_EQ(builds.restore("y", session), 0);
    EXPECT_TRUE(builds.takeNotRead().empty()) << "none is there";
}

TEST_F(KeptBuild, WhatNoLongerFitsIsLeftOut) {
    fs::create_directories(folder);
    std::ofstream(builds.fileOf("x")) << R"({"name": "my build", "placements": [
        {"part": "steel bar", "at": [-1.8, 1.3]}, {"part": "no such part", "at": [0, 1]},
        {"part": "spanner", "at": [40, 1]}]})";
    Session session(gameData().registry, gameData().parts, level());
    EXPECT_EQ(builds.restore("x", session), 2);
    EXPECT_EQ(session.placed().size(), 1U);
    for (char const* damaged : {"", "{", "[]", "{\"placements\": 7}"}) {
        std::ofstream(builds.fileOf("y")) << damaged;
        Session other(gameData().registry, gameData().parts, level());
        EXPECT_EQ(builds.restore("y", other), 0) << damaged;
        EXPECT_TRUE(other.placed().empty()) << damaged;
        EXPECT_EQ(builds.takeDamaged().size(), 1U) << damaged;
        EXPECT_FALSE(fs::exists(builds.fileOf("y"))) << "it was moved aside: " << damaged;
    }
}

// A mod cannot be loaded for a while: what was built with its parts waits for it.
TEST_F(KeptBuild, WhatIsMadeOfAbsentPartsStaysInTheFile) {
    fs::create_directories(folder);
    std::ofstream(builds.fileOf("x")) << R"({"name": "my build", "placements": [
        {"part": "battery", "at": [-1, 0.2]}, {"part": "lamp", "at": [1, 1.5]}, {"part": "fan", "at": [3, 1]}],
        "wires": [["battery 1 plus", "lamp 1"], ["fan 1", "lamp 1"]]})";
    LevelFile const free = readLevel(
        gameData().registry, JsonDocument::parse(freePlayLevel(gameData().parts, "Free", ""), "free.json"));
    {
        Session session(gameData().registry, gameData().parts, free);
        BuildKeeper keeper(builds, "x");
        EXPECT_EQ(keeper.restore(session), 1);
        EXPECT_EQ(session.placed().size(), 2U);
        EXPECT_EQ(session.wires().size(), 1U) << "the wire between what is there";
        ASSERT_TRUE(session.place({"iron ball", {3, 2}, 0, ""}));
        keeper.finish(session);
    }
    PartLibrary parts = gameData().parts;
    PartDefinition fan = *parts.find("lamp"); // as if the mod with the fan were there again
    fan.name = "fan";
    parts.add(std::move(fan));
    LevelFile const again =
        readLevel(gameData().registry, JsonDocument::parse(freePlayLevel(parts, "Free", ""), "free.json"));
    Session session(gameData().registry, parts, again);
    BuildKeeper keeper(builds, "x");
    EXPECT_EQ(keeper.restore(session), 0);
    EXPECT_EQ(session.placed().size(), 4U);
    EXPECT_EQ(session.wires().size(), 2U);
    // What the player clears away is gone, whatever it was made of.
    Session third(gameData().registry, gameData().parts, free);
    BuildKeeper last(builds, "x");
    EXPECT_EQ(last.restore(third), 1);
    ASSERT_TRUE(third.putAllBack());
    last.finish(third);
    EXPECT_FALSE(fs::exists(builds.fileOf("x")));
}

TEST_F(KeptBuild, TheLastGoodOneIsThereForADamagedOne) {
    Placement const bar{"steel bar", {-1.8, 1.3}, 0.1, ""};
    {
        Session session(gameData().registry, gameData().parts, level());
        ASSERT_TRUE(session.place(bar));
        builds.keep("x", buildOf(session));
        ASSERT_TRUE(session.move(session.placed()[0].number, {-1.7, 1.3}, 0.1));
        builds.keep("x", buildOf(session));
    }
    fs::resize_file(builds.fileOf("x"), 20);
    Session session(gameData().registry, gameData().parts, level());
    EXPECT_EQ(builds.restore("x", session), 0);
    ASSERT_EQ(session.placed().size(), 1U);
    EXPECT_EQ(session.placed()[0].placement.at, bar.at);
    std::vector<DamagedFile> const damaged = builds.takeDamaged();
    ASSERT_EQ(damaged.size(), 1U);
    EXPECT_EQ(fs::file_size(damaged[0].aside), 20U);
}

TEST_F(KeptBuild, LevelsHaveFilesOfTheirOwn) {
    EXPECT_NE(builds.fileOf("a/b.json"), builds.fileOf("a-b.json"));
    EXPECT_NE(builds.fileOf("ä"), builds.fileOf("ö"));
    EXPECT_EQ(builds.fileOf("../../etc").parent_path(), folder);
    EXPECT_LT(builds.fileOf(std::string(5000, 'x')).filename().string().size(), 200U);
}

TEST_F(KeptBuild, ThatCannotBeWrittenIsTriedAgain) {
    fs::create_directories(folder.parent_path());
    std::ofstream(folder) << "a file where the folder should be";
    Session session(gameData().registry, gameData().parts, level());
    BuildKeeper keeper(builds, "x");
    keeper.restore(session);
    ASSERT_TRUE(session.place({"steel bar", {-1.8, 1.3}, 0, ""}));
    keeper.finish(session);
    ASSERT_TRUE(builds.unwritten());
    EXPECT_EQ(builds.unwritten()->error(), ENOTDIR);
    // It is there all the same, if the level is opened again meanwhile.
    Session again(gameData().registry, gameData().parts, level());
    BuildKeeper other(builds, "x");
    other.restore(again);
    EXPECT_EQ(again.placed().size(), 1U);
    fs::remove(folder);
    builds.pass(KeptBuilds::patience / 2);
    EXPECT_TRUE(builds.unwritten()) << "not yet";
    builds.pass(KeptBuilds::patience);
    EXPECT_FALSE(builds.unwritten());
    EXPECT_TRUE(fs::exists(builds.fileOf("x")));
}

TEST_F(KeptBuild, FreePlayOffersEveryPart) {
    LevelFile const free = readLevel(
        gameData().registry, JsonDocument::parse(freePlayLevel(gameData().parts, "Free", ""), "free.json"));
    EXPECT_EQ(free.toolbox.size(), gameData().parts.names().size());
    Session session(gameData().registry, gameData().parts, free);
    for (std::string const& part : gameData().parts.names()) {
        EXPECT_TRUE(session.place({part, {0, 2.5}, 0, ""})) << part;
        session.putAllBack();
    }
    EXPECT_FALSE(session.solved());
}

} // namespace
} // namespace trembler
