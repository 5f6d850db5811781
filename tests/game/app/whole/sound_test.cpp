// `trembler run --sound` as a process; skipped if the program has no sound, after testing its message.
#include "tests/game/app/program.hpp"

#include <csignal>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;

class Sound : public InAFolder {
protected:
    void SetUp() override {
        InAFolder::SetUp();
        fs::create_directory(folder / "home");
        std::string const input = level();
        Ran const ran = run({"--frames", "30"});
        if (ran.err.find("made without") != std::string::npos) {
            GTEST_SKIP() << ran.err;
        }
        ASSERT_EQ(ran.status, 1) << ran.err;
    }
    /// Writes heard.wav, as a user whose home folder is empty.
    Ran run(std::vector<std::string> const& more, std::function<void(int)> meanwhile = {}) const {
        std::vector<std::string> arguments{"run", at("level.json"), "--sound", at("heard.wav")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        RunAs how;
        for (char const* const name : {"HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME",
                                       "XDG_STATE_HOME", "XDG_RUNTIME_DIR"}) {
            how.environment.emplace_back(name, at("home"));
        }
        how.meanwhile = std::move(meanwhile);
        return runProgram(arguments, how);
    }
};

TEST_F(Sound, LeavesNothingInTheUsersHome) {
    EXPECT_TRUE(fs::is_empty(folder / "home"));
    EXPECT_EQ(names(), (std::vector<std::string>{"heard.wav", "home", "level.json"}));
}

TEST_F(Sound, OfAnInterruptedRunLeavesTheOldFile) {
    std::string const before = contentsOf(at("heard.wav"));
    BlockingPipe const rows(folder / "rows.csv"); // the run waits before its end
    for (int const signal : {SIGTERM, SIGKILL}) {
        Ran const ran =
            run({"--frames", "10000", "--watch", "world.gravity", "--csv", rows.path()}, [&](int process) {
                EXPECT_TRUE(waitUntil(process, [&] { return writesInto(process, folder); }));
                ::kill(process, signal);
            });
        EXPECT_EQ(ran.status, -1) << ran.err;
        EXPECT_EQ(contentsOf(at("heard.wav")), before);
    }
    EXPECT_EQ(names(), (std::vector<std::string>{"heard.wav", "home", "level.json", "rows.csv"}));
}

TEST_F(Sound, DoesNotReplaceARecordingOrTheTerminal) {
    Ran const terminal = runProgram({"run", at("level.json"), "--sound", "-"});
    EXPECT_EQ(terminal.status, 2);
    EXPECT_NE(terminal.err.find(".wav"), std::string::npos) << terminal.err;
    EXPECT_EQ(terminal.out, "");
    for (std::string const& name : {std::string("-"), std::string(), at("none/x.wav"), at("x.mp3")}) {
        Ran const ran = runProgram({"run", at("level.json"), "--sound", name});
        EXPECT_EQ(ran.status, 2) << name;
        EXPECT_NE(ran.err.find("--sound"), std::string::npos) << ran.err;
        EXPECT_EQ(ran.err.find("is the terminal"), std::string::npos) << ran.err;
    }
    // The level's own recording, which it plays.
    std::string text = contentsOf(at("level.json"));
    std::size_t const name = text.find("\"properties\"");
    ASSERT_NE(name, std::string::npos);
    text.replace(text.find('{', name), 1, R"({"sample": {"file": "heard.wav"}, )");
    write(at("level.json"), text);
    std::string const before = contentsOf(at("heard.wav"));
    Ran const ran = run({"--frames", "5"});
    EXPECT_EQ(ran.status, 2) << ran.out;
    EXPECT_NE(ran.err.find("not overwritten"), std::string::npos) << ran.err;
    EXPECT_EQ(contentsOf(at("heard.wav")), before);
}

} // namespace
} // namespace trembler::test
