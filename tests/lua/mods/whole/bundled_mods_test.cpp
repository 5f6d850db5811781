// The mods that come with the program: each against a formula, and every level of theirs.
#include "physics/magnetism/properties.hpp"
#include "puzzle/solutions/verify.hpp"
#include "tests/lua/support/bundled_mods.hpp"
#include "tests/lua/support/script_world.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <unistd.h>

namespace trembler::lua {
namespace {

namespace fs = std::filesystem;

TEST(BundledMods, WindSpeedsUpASailAsQuadraticDragDoes) {
    auto const game = gameWith({"wind"});
    auto const world = worldOf(*game, R"(
        {"name": "fan", "at": [-2, 0], "angle_deg": 0, "properties": {"fixed": true, "scripts": [{"script": "Dynamics <- Wind",
          "set": [{"param": "speed", "number": 10}, {"param": "reach", "number": 1000}]}]}},
        {"name": "sail", "at": [0, 0], "properties": {"density": 10, "shape": [{"form": "box", "width": 1, "height": 1}]}},
        {"name": "aside", "at": [0, 3], "properties": {"density": 10, "shape": [{"form": "box", "width": 1, "height": 1}]}})");
    ObjectId const sail = world->store().find("sail");
    for (int frame = 0; frame < 60 * 20; ++frame) {
        world->step();
    }
    EXPECT_EQ(errorsOf(*game), "");
    // m dv/dt = c (w - v)^2 gives v = w (1 - 1 / (1 + c w t / m)); c: half density times drag area.
    double const mass = 10 * 1 * 0.1;
    double const c = 0.5 * 1.2 * 1.05 * 1 * 0.1;
    double const expected = 10 * (1 - 1 / (1 + c * 10 * (world->time() - frameDuration) / mass));
    EXPECT_NEAR(world->find<Velocity>(sail)->value.x, expected, 0.005);
    EXPECT_EQ(world->find<Velocity>(world->store().find("aside"))->value.x, 0) << "it is not in the cone";
}

TEST(BundledMods, AntiGravityTakesItsShareOffTheWeight) {
    auto const game = gameWith({"weightless"});
    std::string const ball =
        R"({"name": "ball", "at": [0, 0], "properties": {"material": "wood", "shape": [{"form": "circle", "radius": 0.5}]}})";
    auto const without = worldOf(*game, ball, "[0, -9.81]");
    auto const with =
        worldOf(*game, ball + R"(, {"name": "device", "at": [2, 0], "properties": {"fixed": true,
                                "scripts": [{"script": "Dynamics <- Anti-gravity", "set": [
                                  {"param": "radius", "number": 1000}, {"param": "share", "number": 0.25}]}]}})",
                "[0, -9.81]");
    for (int frame = 0; frame < 120; ++frame) {
        without->step();
        with->step();
    }
    EXPECT_EQ(errorsOf(*game), "");
    double const free = without->find<Velocity>(without->store().find("ball"))->value.y;
    EXPECT_NEAR(free, -9.81 * 2, 0.4);
    EXPECT_NEAR(with->find<Velocity>(with->store().find("ball"))->value.y, 0.75 * free, 1e-3);
}

TEST(BundledMods, PressurePlateCountsWhatLandsOnIt) {
    auto const game = gameWith({"pressure-plate"});
    auto const world = worldOf(*game, R"(
        {"name": "plate", "part": "counting plate", "at": [0, 0]},
        {"name": "early", "at": [-0.2, 0.5], "properties": {"material": "wood", "restitution": 0,
          "shape": [{"form": "box", "width": 0.2, "height": 0.2}]}},
        {"name": "late", "at": [0.2, 6], "properties": {"material": "wood", "restitution": 0,
          "shape": [{"form": "box", "width": 0.2, "height": 0.2}]}})",
                               "[0, -9.81]");
    ObjectId const plate = world->store().find("plate");
    ObjectId const late = world->store().find("late");
    bool landed = false;
    for (int frame = 0; frame < 180; ++frame) {
        world->step();
        if (!landed && world->find<Position>(late)->value.y > 0.5) {
            EXPECT_FALSE(world->find<Magnet>(plate)->on) << "one has landed, and it wants two";
        }
        landed = landed || world->find<Position>(late)->value.y < 0.2;
    }
    EXPECT_EQ(errorsOf(*game), "");
    EXPECT_TRUE(landed);
    EXPECT_TRUE(world->find<Magnet>(plate)->on);
}

TEST(BundledMods, ALevelWithoutItsModSaysWhichIsMissing) {
    GameData const plain;
    try {
        (void)loadLevel(plain.registry, bundledModFolder() / "wind/levels/1-a-fair-wind.json");
        FAIL();
    } catch (InputError const& error) {
        EXPECT_NE(error.diagnostics().front().message.find("the mod 'wind' is not loaded"),
                  std::string::npos);
    }
    Problems problems;
    (void)findMods(std::vector<std::string>{"wnd"}, std::vector<fs::path>{bundledModFolder()}, "level.json",
                   problems);
    try {
        problems.throwIfAny();
        FAIL();
    } catch (InputError const& error) {
        EXPECT_NE(error.diagnostics().front().message.find("did you mean 'wind'?"), std::string::npos);
    }
}

TEST(BundledMods, AModThatIsNotActivatedChangesNoBit) {
    GameData const plain;
    auto const modded = gameWith({"wind", "weightless", "pressure-plate"});
    fs::path const level = plain.home / "levels/experiments/1-switched-electromagnet.json";
    auto const hashOf = [&](GameData const& game) {
        auto const world = buildWorld(game.registry, loadLevel(game.registry, level), game.parts);
        for (int frame = 0; frame < 120; ++frame) {
            world->step();
        }
        return world->stateHash();
    };
    EXPECT_EQ(hashOf(plain), hashOf(*modded));
}

TEST(NewMod, WorksAsItIsMade) {
    fs::path const folder = fs::path(testing::TempDir()) / fmt::format("trembler-mods-{}", ::getpid());
    fs::remove_all(folder);
    writeNewMod(folder / "my-mod", "my-mod");
    EXPECT_THROW(writeNewMod(folder / "my-mod", "my-mod"), std::invalid_argument);
    EXPECT_THROW(writeNewMod(folder / "No Name", "No Name"), std::invalid_argument);
    Problems problems;
    std::vector<Mod> mods =
        findMods(std::vector<std::string>{"my-mod"}, std::vector<fs::path>{folder}, "test", problems);
    problems.throwIfAny();
    GameData const game(std::move(mods));
    for (char const* const level : {"levels/1-push.json", "tests/push.json"}) {
        for (std::string const& failure : verifyLevel(game, folder / "my-mod" / level)) {
            ADD_FAILURE() << failure;
        }
    }
    EXPECT_EQ(errorsOf(game), "");
    fs::remove_all(folder);
}

TEST(Scripts, StatedWronglyAreRefusedWithASuggestion) {
    auto const game = gameWith({"wind"});
    auto const problemOf = [&](std::string const& scripts) -> std::string {
        try {
            (void)worldOf(
                *game,
                fmt::format(
                    R"({{"name": "fan", "at": [0, 0], "properties": {{"fixed": true, "scripts": {}}}}})",
                    scripts));
        } catch (InputError const& error) {
            return error.diagnostics().front().print();
        }
        return "";
    };
    EXPECT_EQ(problemOf(R"([{"script": "Dynamics <- Wind"}])"), "");
    EXPECT_NE(problemOf(R"([{"script": "Dynamics <- Wnd"}])").find("did you mean 'Dynamics <- Wind'?"),
              std::string::npos);
    EXPECT_NE(problemOf(R"([{"script": "Dynamics <- Wind", "set": [{"param": "sped"}]}])")
                  .find("did you mean 'speed'?"),
              std::string::npos);
    EXPECT_NE(problemOf(R"([{"script": "Dynamics <- Wind", "set": [{"param": "speed", "number": 1e9}]}])")
                  .find("expected \"number\" from 0 to 100"),
              std::string::npos);
}

} // namespace
} // namespace trembler::lua
