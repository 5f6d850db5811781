// Scripts that are saved, switched and given other parameters while their level is played.
#include "game/mods/live_mods.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

/// A script that pushes each object that names it, and counts its turns.
std::string pushing(std::string const& body, std::string const& more = "") {
    return "return interaction {\n  name = \"Dynamics <- Push\", calls = \"Dynamics\", reads = { \"Mass\" "
           "},\n"
           "  attached = true, each = { \"Mass\" }, " +
           more +
           "\n  params = { force = { default = 10, min = 0, max = 100, unit = \"N\", text = \"How hard\" } "
           "},\n"
           "  apply = function(object, params, out, store, frame)\n    " +
           body + "\n  end,\n}\n";
}
std::string const push = "out.addForce(object, vec2(params.force, 0))";

/// A mod in a folder of its own and a level with two boxes of 10 kg that name its script.
class WithLiveMods : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) /
                 fmt::format("trembler-live-mods-{}-{}", ::getpid(),
                             testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::create_directories(folder / "pushing/interactions");
        std::ofstream(folder / "pushing/mod.json")
            << R"({"name": "pushing", "version": "1", "author": "me", "licence": "CC0-1.0"})";
        save(pushing(push));
    }
    void TearDown() override {
        liveMods.reset();
        session.reset();
        game.reset();
        fs::remove_all(folder);
    }

    void save(std::string const& text) {
        fs::path const file = folder / "pushing/interactions/push.lua";
        std::ofstream(file, std::ios::binary) << text;
        fs::last_write_time(file, fs::file_time_type(std::chrono::seconds(++saves)));
    }
    void open(std::string const& set = "") {
        Problems problems;
        auto mods = lua::findMods(std::vector<std::string>{"pushing"}, std::vector<fs::path>{folder}, "test",
                                  problems);
        problems.throwIfAny();
        game = std::make_unique<GameData const>(std::move(mods));
        auto const box = [](char const* name, double y, std::string const& settings) {
            return fmt::format(
                R"({{"name": "{}", "at": [0, {}], "properties": {{"mass": 10, "shape": [{{"form": "box",
                   "width": 1, "height": 1}}], "scripts": [{{"script": "Dynamics <- Push", "set": [{}]}}]}}}})",
                name, y, settings);
        };
        std::string const text = fmt::format(
            R"({{"version": 2, "title": "test", "mods": ["pushing"], "world": {{"gravity": [0, 0]}},
               "objects": [{}, {}], "goals": {{"moved": {{"object": "a", "by": 0.01, "towards": "right"}}}}}})",
            box("a", 0, ""), box("b", 5, set));
        session = std::make_unique<Session>(
            game->registry, game->parts, readLevel(game->registry, JsonDocument::parse(text, "test.json")));
        liveMods = std::make_unique<LiveMods>(*game, *session);
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i) {
            session->step();
        }
        liveMods->pass(0);
    }
    /// Checks the files twice, as a changed file is read at the second check.
    void look() {
        liveMods->look();
        liveMods->look();
    }
    [[nodiscard]] double speed(std::string const& name) const {
        World const& world = session->world();
        return world.find<Velocity>(world.store().find(name))->value.x;
    }
    std::string news() {
        std::string all;
        for (ModMessage const& one : liveMods->takeNews()) {
            all += (one.trouble ? "trouble: " : "") + one.text + "\n";
        }
        return all;
    }

    fs::path folder;
    int saves = 0;
    std::unique_ptr<GameData const> game;
    std::unique_ptr<Session> session;
    std::unique_ptr<LiveMods> liveMods;
};

// 10 N on 10 kg are 1/60 m/s in each frame after the first, whose call the second carries out.
double after(int frames, double force = 10) {
    return (frames - 1) / 60.0 * force / 10;
}

TEST_F(WithLiveMods, ASavedScriptTakesOverBetweenTwoFrames) {
    open();
    steps(61);
    EXPECT_NEAR(speed("a"), after(61), 1e-5);
    save(pushing("out.addForce(object, vec2(-params.force, 0))"));
    look();
    EXPECT_EQ(news(), "push.lua is in use as it was saved\n");
    steps(1); // the force of the old version stands until the new one has had its turn
    EXPECT_NEAR(speed("a"), after(62), 1e-5);
    steps(60);
    EXPECT_NEAR(speed("a"), after(62) - 1, 1e-5);
    EXPECT_EQ(liveMods->scripts().front().saved, 1);
}

TEST_F(WithLiveMods, ARunInWhichAScriptWasReplacedCountsAsNoSolution) {
    open();
    steps(30);
    EXPECT_TRUE(session->solved());
    EXPECT_FALSE(session->altered());
    EXPECT_TRUE(session->record("").solves);
    save(pushing(push + " -- as before"));
    look();
    EXPECT_TRUE(session->altered());
    EXPECT_TRUE(session->whyNotRecorded());
    EXPECT_FALSE(session->record("").solves);
    session->stop();
    EXPECT_FALSE(session->altered()) << "the next run is one with the new version from its beginning";
    steps(30);
    EXPECT_TRUE(session->record("").solves);
}

TEST_F(WithLiveMods, ARunAfterASavingIsTheSameAsInAProgramThatFoundTheFileSo) {
    open();
    steps(7);
    std::string const text = pushing("out.addForce(object, vec2(2 * params.force, 1))");
    save(text);
    look();
    session->stop();
    steps(50);
    std::uint64_t const hash = session->world().stateHash();
    liveMods.reset();
    open();
    steps(50);
    EXPECT_EQ(session->world().stateHash(), hash);
}

TEST_F(WithLiveMods, AnErrorLeavesTheOldVersionAndIsShownWithFileAndLine) {
    open();
    steps(10);
    save(pushing("out.addForce(object vec2(1, 0))"));
    look();
    std::string const said = news();
    EXPECT_NE(said.find("trouble: push.lua is not used"), std::string::npos) << said;
    EXPECT_NE(said.find("push.lua:6:"), std::string::npos) << said;
    EXPECT_EQ(liveMods->scripts().front().refused.size(), 1U);
    EXPECT_FALSE(session->altered());
    steps(51);
    EXPECT_NEAR(speed("a"), after(61), 1e-5) << "the old version goes on";
    for (auto const& [text, expected] : std::vector<std::pair<std::string, std::string>>{
             {pushing(push, "reads_ = {},"), "unknown key 'reads_'"},
             {"return interaction { name = \"Dynamics <- Other\", calls = \"Dynamics\", each = { \"Mass\" }, "
              "apply = function() end }",
              "the interaction was 'Dynamics <- Push' and is 'Dynamics <- Other' now"}}) {
        save(text);
        look();
        std::string const now = news();
        EXPECT_NE(now.find(expected), std::string::npos) << now;
    }
    fs::remove(folder / "pushing/interactions/push.lua");
    look();
    EXPECT_NE(news().find("cannot be read any more"), std::string::npos);
    save(pushing(push));
    look();
    EXPECT_EQ(news(), "push.lua is in use as it was saved\n");
    EXPECT_TRUE(liveMods->scripts().front().refused.empty());
}

TEST_F(WithLiveMods, AVersionThatTheLevelDoesNotFitIsRefused) {
    open(R"({"param": "force", "number": 20})");
    steps(10);
    std::string text = pushing(push);
    text.replace(text.find("max = 100"), 9, "max = 15 ");
    save(text);
    look();
    EXPECT_NE(news().find("expected \"number\" from 0 to 15"), std::string::npos);
    steps(51);
    EXPECT_NEAR(speed("b"), after(61, 20), 1e-5);
    EXPECT_NO_THROW(session->stop());
}

TEST_F(WithLiveMods, StateIsKeptWhereTheDeclarationsAgree) {
    std::string const counting = "store.object.turns = store.object.turns + 1\n"
                                 "store.script.all = store.script.all + 1\n"
                                 "log(store.object.turns, store.script.all)";
    save(pushing(counting, "restless = true, store = { object = { turns = 0 }, script = { all = 0 } },"));
    open();
    steps(3);
    EXPECT_EQ(liveMods->scripts().front().log.back(), "3 6");
    // 'all' is a text now and begins again; 'turns' continues; 'fresh' is new.
    save(pushing(
        "store.object.turns = store.object.turns + 1\n"
        "store.object.fresh = store.object.fresh + 1\n"
        "log(store.object.turns, store.object.fresh, store.script.all)",
        "restless = true, store = { object = { turns = 0, fresh = 10 }, script = { all = 'none' } },"));
    look();
    steps(1);
    EXPECT_EQ(liveMods->scripts().front().log.back(), "4 11 none");
}

TEST_F(WithLiveMods, ANewVersionMayReadMore) {
    open();
    steps(10);
    std::string text = pushing("log(#world.contacts.current, object.Velocity.value.x > 0)");
    text.replace(text.find("\"Mass\""), 6, "\"Mass\", \"Velocity\", \"contacts\"");
    save(text);
    look();
    steps(2);
    EXPECT_FALSE(liveMods->scripts().front().failure);
    ASSERT_FALSE(liveMods->scripts().front().log.empty());
    EXPECT_EQ(liveMods->scripts().front().log.back(), "0 true");
}

TEST_F(WithLiveMods, AScriptThatFailsIsReportedOnceInARunAndTheWorldGoesOn) {
    save(pushing("error('oh no')"));
    open();
    steps(20);
    EXPECT_EQ(news(), "trouble: Dynamics <- Push is switched off: push.lua:6: oh no\n");
    ASSERT_TRUE(liveMods->scripts().front().failure);
    EXPECT_NE(liveMods->scripts().front().failure->traceback, "");
    EXPECT_TRUE(liveMods->scripts().front().live->failed());
    EXPECT_EQ(session->world().frame(), 20U);
    EXPECT_EQ(news(), "");
    save(pushing(push)); // corrected while the world runs
    look();
    EXPECT_FALSE(liveMods->scripts().front().failure);
    steps(61);
    EXPECT_NEAR(speed("a"), after(61), 1e-5);
    session->stop();
    EXPECT_EQ(news(), "push.lua is in use as it was saved\n");
}

TEST_F(WithLiveMods, ASwitchedOffScriptTakesItsForcesBack) {
    open();
    steps(61);
    liveMods->setOn(0, false);
    EXPECT_TRUE(liveMods->changed(0));
    EXPECT_TRUE(session->altered());
    steps(30);
    EXPECT_NEAR(speed("a"), after(61), 1e-5);
    session->stop();
    EXPECT_TRUE(session->altered()) << "it is still off";
    steps(30);
    EXPECT_EQ(speed("a"), 0);
    liveMods->setOn(0, true);
    steps(61);
    EXPECT_NEAR(speed("a"), after(61), 1e-5);
    session->stop();
    EXPECT_FALSE(session->altered());
}

TEST_F(WithLiveMods, ParametersChangeForAllThatStateNone) {
    open(R"({"param": "force", "number": 20})");
    liveMods->setDefault(0, "force", 50.0);
    EXPECT_TRUE(liveMods->changed(0));
    EXPECT_TRUE(session->altered());
    liveMods->setDefault(0, "force", 500.0);
    liveMods->setDefault(0, "force", true);
    liveMods->setDefault(0, "farce", 5.0);
    EXPECT_EQ(liveMods->scripts().front().defaults.at("force"), lua::Value(50.0)) << "those are no values";
    steps(61);
    EXPECT_NEAR(speed("a"), after(61, 50), 1e-4);
    EXPECT_NEAR(speed("b"), after(61, 20), 1e-4);
    liveMods->setDefault(0, "force", 10.0);
    EXPECT_FALSE(liveMods->changed(0));
}

TEST_F(WithLiveMods, ParametersChangeForOneObjectInThisWorldAndTheNext) {
    open(R"({"param": "force", "number": 20})");
    auto const users = liveMods->users(0);
    ASSERT_EQ(users.size(), 2U);
    EXPECT_EQ(users[1].name, "b");
    EXPECT_EQ(users[0].values.at("force"), lua::Value(10.0));
    EXPECT_EQ(users[1].values.at("force"), lua::Value(20.0));
    liveMods->setFor(0, users[1].object, "force", 40.0);
    for (int run = 0; run < 2; ++run) {
        steps(61);
        EXPECT_NEAR(speed("a"), after(61), 1e-4);
        EXPECT_NEAR(speed("b"), after(61, 40), 1e-4);
        session->stop();
    }
    EXPECT_TRUE(session->altered());
    liveMods->asStated(0);
    EXPECT_FALSE(session->altered());
    EXPECT_EQ(liveMods->users(0)[1].values.at("force"), lua::Value(20.0));
    steps(61);
    EXPECT_NEAR(speed("b"), after(61, 20), 1e-4);
}

TEST_F(WithLiveMods, ItIsSeenWhatAScriptUses) {
    open();
    EXPECT_FALSE(liveMods->scripts().front().live->usage());
    steps(2);
    auto const usage = liveMods->scripts().front().live->usage();
    ASSERT_TRUE(usage);
    EXPECT_EQ(usage->targets, 2U);
    EXPECT_GT(usage->mostInstructions, usage->instructions);
    EXPECT_GT(usage->bytes, 0U);
    EXPECT_GT(usage->mostBytes, usage->bytes);
}

} // namespace
} // namespace trembler
