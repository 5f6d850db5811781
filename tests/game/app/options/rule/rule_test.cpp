// One rule for all options of all commands: a value that is empty, doubled, unknown, out of its range, or a
// file that cannot be, is refused before anything runs, by one line that names the option, the value and what
// was expected.
#include "game/app/options/rule/rule.hpp"
#include "tests/game/app/options/option_table.hpp"
#include "tests/game/app/program.hpp"

namespace trembler::test {
namespace {

std::string joined(std::vector<std::string> const& words) {
    std::string text;
    for (std::string const& word : words) {
        text += (text.empty() ? "" : " ") + shown(word);
    }
    return text;
}

class EveryOption : public InAFolder {
protected:
    void SetUp() override {
        InAFolder::SetUp();
        places.emplace(folder);
        options = allOptions(*places);
        before = names();
        ASSERT_GT(options.size(), 90U);
    }
    void TearDown() override {
        EXPECT_EQ(names(), before) << "parsing wrote something";
        InAFolder::TearDown();
    }

    /// Expects a refusal whose line shows `value`.
    void expectRefused(TestedOption const& option, std::vector<std::string> const& so,
                       std::string const& value, std::string const& why) const {
        std::vector<std::string> const arguments = option.stated(so);
        Request const request = requestFrom(arguments);
        std::string const what = why + ": " + joined(arguments) + "\n  " + request.err;
        EXPECT_EQ(request.work, nullptr) << what;
        EXPECT_EQ(request.status, 2) << what;
        EXPECT_EQ(request.out, "") << what;
        EXPECT_TRUE(request.err.starts_with("trembler: ")) << what;
        EXPECT_EQ(std::count(request.err.begin(), request.err.end(), '\n'), 1) << what;
        EXPECT_NE(request.err.find(option.name), std::string::npos) << what;
        EXPECT_NE(request.err.find("expected"), std::string::npos) << what;
        EXPECT_NE(request.err.find(shown(value)), std::string::npos) << what;
        EXPECT_EQ(request.err.find("filesystem error"), std::string::npos) << what;
        EXPECT_LT(request.err.size(), 1500U) << what;
    }

    std::optional<Places> places;
    std::vector<TestedOption> options;
    std::vector<std::string> before;
};

TEST_F(EveryOption, SaysWhatItExpects) {
    for (TestedOption const& option : options) {
        EXPECT_EQ(option.expected.empty(), option.flag) << option.words();
    }
}

TEST_F(EveryOption, TakesRightValues) { // or the other tests would hold for an option that refuses everything
    for (TestedOption const& option : options) {
        std::vector<std::vector<std::string>> right;
        if (option.flag) {
            right.push_back({option.name});
        }
        std::vector<std::string> list;
        for (std::string const& value : option.right) {
            right.push_back(option.with(value));
            list.insert(list.end(), right.back().begin(), right.back().end());
        }
        if (option.list) {
            right.push_back(list);
        }
        for (auto const& so : right) {
            Request const request = requestFrom(option.stated(so));
            EXPECT_NE(request.work, nullptr) << joined(option.stated(so)) << "\n  " << request.err;
        }
    }
}

TEST_F(EveryOption, RefusesEmptyValues) {
    for (TestedOption const& option : options) {
        if (!option.flag) {
            expectRefused(option, option.with(""), "", "empty");
        }
        if (option.name.starts_with("-")) {
            expectRefused(option, {option.name + "="}, "", "empty behind =");
        }
    }
}

TEST_F(EveryOption, RefusesToBeStatedTwice) {
    for (TestedOption const& option : options) {
        if (option.flag) {
            expectRefused(option, {option.name, option.name}, "", "twice");
            continue;
        }
        for (std::string const& second : option.right) {
            if (option.list && second != option.right.front()) {
                continue; // a list takes different values
            }
            if (!option.name.starts_with("-") && !option.list) {
                // The parser takes a second argument for one too many.
                Request const request = requestFrom(option.stated({option.right.front(), second}));
                EXPECT_EQ(request.work, nullptr) << option.words();
                EXPECT_NE(request.err.find(shown(second)), std::string::npos) << request.err;
                continue;
            }
            std::vector<std::string> so = option.with(option.right.front());
            std::vector<std::string> const again = option.with(second);
            so.insert(so.end(), again.begin(), again.end());
            expectRefused(option, so, second, "twice");
        }
    }
    // Values of different keys are a list; of the same key they contradict each other.
    for (auto const& [option, one, other] :
         {std::array{"--detail", "dynamics=chipmunk", "dynamics=box2d"},
          std::array{"--period", "Dynamics Resolver=2", "Dynamics Resolver=3"}}) {
        Request const request = requestFrom({"run", places->level, option, one, option, other});
        EXPECT_EQ(request.work, nullptr);
        EXPECT_NE(request.err.find(one), std::string::npos) << request.err;
        EXPECT_NE(request.err.find(other), std::string::npos) << request.err;
    }
}

// "level.json", "./level.json" and a link to it are the same file.
TEST_F(EveryOption, RefusesAPathThatIsStatedInAnotherSpelling) {
    namespace fs = std::filesystem;
    int paths = 0;
    for (TestedOption const& option : options) {
        fs::path const first = option.list ? option.right.front() : std::string();
        if (first.empty() || !fs::exists(first) || option.name == "--trust") {
            continue;
        }
        ++paths;
        for (std::string const& second : {(first.parent_path() / "." / first.filename()).string(),
                                          (first.parent_path() / "absent" / ".." / first.filename()).string(),
                                          first.parent_path().string() + "//" + first.filename().string()}) {
            std::vector<std::string> so = option.with(first.string());
            std::vector<std::string> const again = option.with(second);
            so.insert(so.end(), again.begin(), again.end());
            expectRefused(option, so, second, "in another spelling");
        }
    }
    EXPECT_GT(paths, 10) << "LEVEL and --mod of the commands";
}

TEST_F(EveryOption, RefusesWrongValues) {
    for (TestedOption const& option : options) {
        for (Wrong const& wrong : option.wrong) {
            expectRefused(option, wrong.arguments, wrong.value, wrong.why);
        }
    }
}

TEST_F(EveryOption, RefusesAnotherOptionForItsValue) {
    for (TestedOption const& option : options) {
        if (option.flag || !option.name.starts_with("-")) {
            continue;
        }
        // "--csv --svg" would write a file of the name --svg. A FILE that may be left out is left out.
        Request const request = requestFrom(option.stated({option.name, option.name}));
        EXPECT_EQ(request.work, nullptr) << option.words();
        EXPECT_NE(request.err.find(option.name), std::string::npos) << request.err;
        if (option.expected.find("terminal") == std::string::npos || option.name == "--out" ||
            option.name == "--trace") {
            expectRefused(option, {option.name}, "", "without a value");
        }
    }
}

TEST_F(EveryOption, RefusesValuesOfFlags) {
    for (TestedOption const& option : options) {
        for (char const* const value : {"no", "false", "true", "0", "1", "2", "x"}) {
            if (option.flag) {
                std::string const stated = option.name + "=" + value;
                if (stated.ends_with("=true")) {
                    continue; // says what the flag says
                }
                expectRefused(option, {stated}, stated, "a value of a flag");
            }
        }
    }
}

TEST_F(EveryOption, SuggestsTheNearestWord) {
    auto const answer = [&](std::vector<std::string> const& arguments) {
        Request const request = requestFrom(arguments);
        EXPECT_EQ(request.work, nullptr) << joined(arguments);
        EXPECT_EQ(request.status, 2) << joined(arguments);
        EXPECT_EQ(std::count(request.err.begin(), request.err.end(), '\n'), 1) << request.err;
        return request.err;
    };
    auto const expect = [&](std::vector<std::string> const& arguments, std::string const& part) {
        std::string const said = answer(arguments);
        EXPECT_NE(said.find(part), std::string::npos) << said;
    };
    expect({"rnu"}, "(did you mean 'run'?)");
    expect({}, "a command is missing");
    expect({"mod"}, "a command is missing");
    expect({"mod", "chek", "tap"}, "(did you mean 'check'?)");
    expect({"--versoin"}, "(did you mean '--version'?)");
    expect({"run", places->level, "--frmes", "3"},
           "--frmes: trembler run has no such option (did you mean '--frames'?)");
    expect({"run", places->level, places->otherLevel}, "takes no such argument");
    expect({"run", places->level, "--detail", "dynamics=chipmonk"}, "(did you mean 'chipmunk'?)");
    expect({"run", places->level, "--detail", "dynamic=chipmunk"}, "(did you mean 'dynamics'?)");
    expect({"accuracy", "gravty"}, "(did you mean 'gravity'?)");
    expect({"schema", "prat"}, "(did you mean 'part'?)");
    expect({"mod", "check", "tapp"}, "(did you mean 'tap'?)");
    expect({"run", "--frames", "3"}, "LEVEL is required");
    expect({"screenshot", places->level}, "--out is required");
    expect({"report", places->level, "--table"}, "--markdown");
    expect({"run", places->level, "--every", "3"}, "--every: expected --csv");
    // Of what would have no effect, or would ask about what is never run.
    expect({"report", places->level, "--seed", "5", "--runs", "0", "--drops", "0"},
           "--seed: expected --runs");
    for (char const* const jitter : {"--jitter-cm", "--jitter-degrees", "--jitter-seconds"}) {
        expect({"report", places->level, jitter, "1", "--runs", "0"},
               std::string(jitter) + ": expected --runs");
    }
    expect({"why", places->level, "--object", "b", "--at", "2", "--frames", "10"}, "--at: expected at most");
}

TEST_F(EveryOption, HasTheNameOfItsFileInItsOwnForm) {
    // Names without an ending, in capital letters, and of devices say nothing wrong.
    for (std::vector<std::string> const& more :
         std::vector<std::vector<std::string>>{{"--csv", at("table"), "--watch", "world.gravity"},
                                               {"--csv", at("TABLE.CSV"), "--watch", "world.gravity"},
                                               {"--csv", at("table.txt"), "--watch", "world.gravity"},
                                               {"--trace", "/dev/null"},
                                               {"--sound", at("IT.WAV")}}) {
        std::vector<std::string> arguments{"run", places->level};
        arguments.insert(arguments.end(), more.begin(), more.end());
        Request const request = requestFrom(arguments);
        EXPECT_NE(request.work, nullptr) << request.err;
    }
}

/// What depends on the level is refused once the level is read, and before it runs.
class OptionsAboutTheLevel : public InAFolder {};

TEST_F(OptionsAboutTheLevel, AreRefusedBeforeItRuns) {
    std::string const input = level();
    std::string const picture = at("new.png");
    auto const before = names();
    struct Case {
        std::vector<std::string> arguments;
        std::vector<std::string> parts; ///< of the message
    };
    for (Case const& one : std::vector<Case>{
             {{"run", input, "--solution", "a steel bar in it place"},
              {"--solution a steel bar in it place", "did you mean 'a steel bar in its place'", "are: "}},
             {{"why", input, "--solution", "x"}, {"--solution x", "are: "}},
             {{"screenshot", input, "--out", picture, "--solution", "x"}, {"--solution x", "are: "}},
             {{"clip", input, "--out", at("new.webp"), "--solution", "x"}, {"--solution x", "are: "}},
             {{"run", input, "--period", "Dynamics Resolvr=2"},
              {"--period Dynamics Resolvr=2", "did you mean 'Dynamics Resolver'"}},
             {{"run", input, "--watch", "world.gravty", "--csv", at("new.csv")},
              {"--watch world.gravty", "did you mean"}},
             {{"run", input, "--watch", "nobody.position", "--svg", at("new.svg")},
              {"--watch nobody.position"}},
             {{"run", input, "--hash-every", "1", "--frames", "1000001"},
              {"--hash-every 1", "1000001 hashes", "at most 1000000"}},
             {{"run", input, "--sound", at("new.wav"), "--frames", "2000000"},
              {"--sound", "has 2000000 frames", "at most 1342"}},
             {{"why", input, "--goal", "x"}, {"--goal x", "expected"}},
             {{"why", input, "--object", "x", "--at", "1"}, {"--object x"}}}) {
        Ran const ran = runProgram(one.arguments);
        if (ran.err.find("made without") != std::string::npos) {
            continue; // a program without the window refuses the whole command
        }
        EXPECT_EQ(ran.status, 2) << joined(one.arguments);
        EXPECT_EQ(ran.out, "") << joined(one.arguments);
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
        for (std::string const& part : one.parts) {
            EXPECT_NE(ran.err.find(part), std::string::npos) << ran.err;
        }
        EXPECT_EQ(names(), before) << joined(one.arguments);
    }
}

} // namespace
} // namespace trembler::test
