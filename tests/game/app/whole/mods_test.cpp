// Mods on the command line: mod new, check and list, and levels whose mods are missing or wrong.
#include "tests/game/app/program.hpp"

#include <algorithm>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;

class Mods : public InAFolder {
protected:
    static bool contains(std::string const& text, std::string const& part) {
        return text.find(part) != std::string::npos;
    }
    /// With a user's data folder of the test's own.
    [[nodiscard]] Ran run(std::vector<std::string> const& arguments) const {
        return runProgram(arguments, {.environment = {{"XDG_DATA_HOME", at("data")}}});
    }
    void makeMod(std::string const& name, std::string const& in) const {
        Ran const ran = run({"mod", "new", name, "--in", in});
        ASSERT_EQ(ran.status, 0) << ran.err;
    }
    void replace(std::string const& file, std::string const& what, std::string const& with) const {
        std::string text = contentsOf(file);
        std::size_t const place = text.find(what);
        ASSERT_NE(place, std::string::npos) << what;
        write(file, text.replace(place, what.size(), with));
    }
};

TEST_F(Mods, ANewModIsGood) {
    makeMod("my-mod", folder.string());
    Ran const checked = run({"mod", "check", at("my-mod")});
    EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    EXPECT_TRUE(contains(checked.out, "my-mod: 1 interaction, 2 levels and tests, 0 warnings"))
        << checked.out;
    EXPECT_TRUE(contains(checked.out, "all good")) << checked.out;
    Ran const listed = run({"mod", "list", "--mod", folder.string()});
    EXPECT_TRUE(contains(listed.out, "(Dynamics <- my-mod)")) << listed.out;
    EXPECT_TRUE(contains(listed.out, "(Dynamics <- Wind)")) << "and the mods that come with the program";
}

TEST_F(Mods, ThatCannotBeLookedAtAreNotCalledMissing) {
    Ran const checked = run({"mod", "check", std::string(300, 'm')});
    EXPECT_EQ(checked.status, 2);
    EXPECT_TRUE(contains(checked.err, "cannot be read: File name too long")) << checked.err;
    EXPECT_TRUE(contains(run({"mod", "check", "absent"}).err, "there is no such mod"));
}

// A check says nothing good of what it has not looked at.
TEST_F(Mods, FilesThatNothingLooksAtAreWarnedOf) {
    makeMod("my-mod", folder.string());
    std::vector<std::string> const overlooked{
        "pull.lua",      "interactions/more/pull.lua", "interactions/pull.LUA", "levels/chapter/2-bad.json",
        "levels/3.JSON", "tests/more/4.json"};
    for (std::string const& file : overlooked) {
        std::filesystem::create_directories(std::filesystem::path(at("my-mod/" + file)).parent_path());
        write(at("my-mod/" + file), "not good");
    }
    Ran const checked = run({"mod", "check", at("my-mod")});
    EXPECT_EQ(checked.status, 0) << checked.out << checked.err;
    EXPECT_TRUE(contains(checked.out, "6 warnings")) << checked.out;
    for (std::string const& file : overlooked) {
        EXPECT_TRUE(contains(checked.out, "warning: " + at("my-mod/" + file) + ": is no")) << checked.out;
    }
}

TEST_F(Mods, FoldersThatCannotBeReadFailTheCheck) {
    for (std::string const part : {"interactions", "levels", "tests"}) {
        makeMod("my-mod", folder.string());
        std::string const wrong = at("my-mod/" + part);
        std::filesystem::remove_all(wrong);
        write(wrong, "a file in its place");
        Ran const checked = run({"mod", "check", at("my-mod")});
        EXPECT_EQ(checked.status, 2) << checked.out << checked.err;
        EXPECT_TRUE(contains(checked.err, wrong + ": cannot be read: ")) << checked.err;
        std::filesystem::remove_all(at("my-mod"));
    }
}

TEST_F(Mods, ANewModThatCannotBeWrittenLeavesNothing) {
    Ran const failed = runProgram({"mod", "new", "my-mod", "--in", folder.string()}, {.longestFile = 2000});
    EXPECT_NE(failed.status, 0);
    EXPECT_FALSE(std::filesystem::exists(at("my-mod"))) << failed.err;
    makeMod("my-mod", folder.string());
    EXPECT_EQ(run({"mod", "new", "my-mod", "--in", folder.string()}).status, 2);
    EXPECT_TRUE(std::filesystem::exists(at("my-mod/mod.json"))) << "the mod before stays";
}

TEST_F(Mods, AMistakeIsReportedWithFileAndLineAndNothingIsChecked) {
    makeMod("my-mod", folder.string());
    std::string const script = at("my-mod/interactions/push.lua");
    replace(script, "apply = function", "aply = function");
    Ran const checked = run({"mod", "check", at("my-mod")});
    EXPECT_EQ(checked.status, 2);
    EXPECT_TRUE(contains(checked.err, "push.lua:")) << checked.err;
    EXPECT_TRUE(contains(checked.err, "unknown key 'aply' (did you mean 'apply'?)")) << checked.err;
}

TEST_F(Mods, AScriptThatFailsInATestFailsTheCheckWithItsLine) {
    makeMod("my-mod", folder.string());
    std::string const script = at("my-mod/interactions/push.lua");
    replace(script, "out.addForce(object, vec2(params.force, 0))", "error('oh no')");
    std::string const text = contentsOf(script);
    auto const line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("error('")), '\n');
    Ran const checked = run({"mod", "check", at("my-mod")});
    EXPECT_EQ(checked.status, 1);
    EXPECT_TRUE(contains(checked.out, "interactions/push.lua:" + std::to_string(line) + ": oh no"))
        << checked.out;
    EXPECT_TRUE(contains(checked.out, "is switched off in frame 1")) << checked.out;
    EXPECT_TRUE(contains(checked.out, "not good")) << checked.out;
    // Names that are not used any more are reported, too.
    EXPECT_TRUE(contains(checked.out, "warning: ")) << checked.out;
    EXPECT_TRUE(contains(checked.out, "the parameter 'force' has no effect")) << checked.out;
}

// Each script differs in one condition from one that is applied.
TEST_F(Mods, AScriptThatNeverRanIsReportedWithTheReason) {
    makeMod("my-mod", folder.string());
    std::string const script = contentsOf(at("my-mod/interactions/push.lua"));
    auto const interaction = [](std::string const& name, std::string const& selection) {
        return "return interaction { name = \"Dynamics <- " + name +
               "\", text = \"Tries.\", calls = \"Dynamics\", reads = {},\n" + selection +
               ",\napply = function(a, b, params, out) end }\n";
    };
    struct Case {
        std::string selection;
        std::string why; // empty: it is applied
    };
    std::vector<Case> const cases{
        {"each = { \"Velocity\" }", ""},
        {"once = true", ""},
        {"pairs = { first = { \"Velocity\" }, second = { \"Fixed\" }, touching = true }", ""},
        {"pairs = { first = { \"Velocity\" }, second = { \"Fixed\" }, within = 50 }", ""},
        {"each = { \"Magnet on/off\" }", "no object has 'Magnet on/off'"},
        {"each = { \"Velocity\", \"Fixed\" }", "no object has 'Velocity' and 'Fixed' at once"},
        {"attached = true, each = { \"Velocity\" }", "no object names 'Dynamics <- CASE' under \"scripts\""},
        {"pairs = { first = { \"Velocity\", \"Fixed\" }, second = { \"Mass\" }, within = 1 }",
         "no object has 'Velocity' and 'Fixed' at once"},
        {"pairs = { first = { \"Mass\" }, second = { \"Velocity\", \"Fixed\" }, within = 1 }",
         "no object has 'Velocity' and 'Fixed' at once, as the second of a pair must"},
        {"pairs = { first = { \"Velocity\" }, second = { \"Velocity\" }, touching = true }",
         "no two of its objects touch each other"},
        {"pairs = { first = { \"Velocity\" }, second = { \"Velocity\" }, within = 2.5 }",
         "no two of its objects come within 2.5 m of each other"},
        {"pairs = { first = { \"Velocity\" }, second = { \"Velocity\" }, within = \"reach\" }, params = { "
         "reach = { "
         "default = 2, min = 0, max = 3, text = \"Far\", unit = \"m\" } }",
         "come as near to each other as 'reach' states"},
    };
    for (std::size_t i = 0; i < cases.size(); ++i) {
        write(at("my-mod/interactions/case-" + std::to_string(i) + ".lua"),
              interaction("case " + std::to_string(i), cases[i].selection));
    }
    Ran const checked = run({"mod", "check", at("my-mod")});
    EXPECT_EQ(checked.status, 0) << "a warning, as it may be meant\n" << checked.out << checked.err;
    std::size_t reported = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        std::string const name = "case " + std::to_string(i);
        std::string const never = "case-" + std::to_string(i) + ".lua:1:22: 'Dynamics <- " + name +
                                  "' never ran, as it is applied to nothing in 2 levels and tests";
        std::string why = cases[i].why;
        if (std::size_t const place = why.find("CASE"); place != std::string::npos) {
            why.replace(place, 4, name);
        }
        std::size_t const line = checked.out.find(never);
        EXPECT_EQ(line == std::string::npos, why.empty()) << never << "\n" << checked.out;
        reported += why.empty() ? 0 : 1;
        if (line != std::string::npos) {
            EXPECT_TRUE(contains(checked.out.substr(line, checked.out.find('\n', line) - line), why))
                << why << "\n"
                << checked.out.substr(line, 300);
        }
    }
    EXPECT_EQ(reported, 8U);
    EXPECT_FALSE(contains(checked.out, "'Dynamics <- my-mod' never ran")) << checked.out;
}

// Found by a solution only, and reasons that differ between levels.
TEST_F(Mods, AScriptThatRunsInASolutionHasRun) {
    makeMod("my-mod", folder.string());
    replace(at("my-mod/levels/1-push.json"),
            "\"scripts\": [{\"script\": \"Dynamics <- my-mod\", \"set\": [{\"param\": \"force\", \"number\": "
            "20}]}]",
            "\"velocity\": [5, 0]");
    Ran const one = run({"mod", "check", at("my-mod")});
    EXPECT_FALSE(contains(one.out, "never ran")) << "the test still names it\n" << one.out;
    replace(at("my-mod/tests/push.json"),
            "\"scripts\": [{\"script\": \"Dynamics <- my-mod\", \"set\": [{\"param\": \"force\", \"number\": "
            "20}]}]",
            "\"velocity\": [5, 0]");
    Ran const none = run({"mod", "check", at("my-mod")});
    EXPECT_TRUE(contains(none.out, "push.lua:3:3: 'Dynamics <- my-mod' never ran")) << none.out;
    EXPECT_TRUE(contains(none.out, "no object names 'Dynamics <- my-mod' under \"scripts\"")) << none.out;
    EXPECT_TRUE(contains(none.out, " 1 warning,")) << none.out;
}

TEST_F(Mods, AFolderWhoseNameNoModMayHaveIsNotSuggestedForItself) {
    makeMod("my-mod", folder.string());
    fs::rename(folder / "my-mod", folder / "m_base");
    Ran const checked = run({"mod", "check", at("m_base")});
    EXPECT_EQ(checked.status, 2);
    EXPECT_TRUE(contains(checked.err, "'m_base' cannot be the name of a mod")) << checked.err;
    EXPECT_TRUE(contains(checked.err, "small letters, digits and -")) << checked.err;
    EXPECT_FALSE(contains(checked.err, "did you mean")) << checked.err;
    write(at("level.json"), R"({"version": 2, "title": "a", "mods": ["m_base"], "objects": []})");
    Ran const ran = run({"run", at("level.json"), "--frames", "1", "--mod", folder.string()});
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(contains(ran.err, "'m_base' cannot be the name of a mod")) << ran.err;
    EXPECT_FALSE(contains(ran.err, "did you mean")) << ran.err;
}

TEST_F(Mods, AreFoundBesideALevelInTheUsersFolderAndWhereTheyAreStated) {
    makeMod("my-mod", at("elsewhere"));
    fs::create_directories(folder / "pack");
    fs::copy_file(folder / "elsewhere/my-mod/levels/1-push.json", folder / "pack/level.json");
    std::vector<std::string> const solve{"run", at("pack/level.json"), "--solution", "hands off"};
    Ran const missing = run(solve);
    EXPECT_EQ(missing.status, 2);
    EXPECT_TRUE(contains(missing.err, "the level needs the mod 'my-mod', which is not in ")) << missing.err;
    for (char const* const place : {"pack/mods", "data/trembler/mods"}) {
        EXPECT_TRUE(contains(missing.err, at(place))) << "it was looked for in " << place << "\n"
                                                      << missing.err;
    }
    Ran const unverified = run({"verify", at("pack")});
    EXPECT_EQ(unverified.status, 1);
    EXPECT_TRUE(contains(unverified.out, "needs the mod 'my-mod'")) << unverified.out;
    std::vector<std::string> stated = solve;
    stated.insert(stated.end(), {"--mod", at("elsewhere")});
    EXPECT_EQ(run(stated).status, 0);
    EXPECT_EQ(run({"verify", at("pack"), "--mod", at("elsewhere")}).status, 0);
    EXPECT_EQ(run({"verify", at("pack"), "--mod", at("elsewhere/my-mod")}).status, 0)
        << "the mod's own folder";
    for (char const* const place : {"pack/mods", "data/trembler/mods"}) {
        fs::create_directories(folder / place);
        fs::copy(folder / "elsewhere/my-mod", folder / place / "my-mod", fs::copy_options::recursive);
        EXPECT_EQ(run(solve).status, 0) << place;
        fs::remove_all(folder / place);
    }
}

TEST_F(Mods, NoCommandThatReadsAModReplacesItsFiles) {
    makeMod("my-mod", folder.string());
    fs::create_directories(folder / "my-mod/parts");
    write(folder / "my-mod/parts/cube.json", R"({"name": "cube", "properties": {"mass": 1}})");
    std::string const level = at("my-mod/levels/1-push.json");
    for (char const* const name :
         {"mod.json", "interactions/push.lua", "parts/cube.json", "levels/1-push.json"}) {
        std::string const file = at(std::string("my-mod/") + name);
        std::string const before = contentsOf(file);
        for (std::vector<std::string> const& command : std::vector<std::vector<std::string>>{
                 {"components", "--mod", folder.string(), "--json", file},
                 {"components", "--mod", folder.string(), "--markdown", file},
                 {"verify", level, "--mod", folder.string(), "--json", file},
                 {"report", level, "--brief", "--runs", "0", "--drops", "0", "--json", file},
                 {"report", level, "--brief", "--runs", "0", "--drops", "0", "--resume", file},
                 {"solve", level, "--runs", "1", "--json", file},
                 {"solve", level, at("my-mod/tests/push.json"), "--runs", "1", "--markdown", file},
                 {"why", level, "--frames", "2", "--json", file},
                 {"run", level, "--frames", "2", "--json", file}}) {
            Ran const ran = run(command);
            EXPECT_EQ(ran.status, 2) << command.front() << " " << name;
            EXPECT_TRUE(contains(ran.err, "not overwritten") || contains(ran.err, "the file will hold"))
                << ran.err;
            EXPECT_EQ(contentsOf(file), before) << command.front() << " " << name;
        }
    }
}

TEST_F(Mods, AModWithAMistakeIsNotReplacedByTheReportOnIt) {
    makeMod("my-mod", folder.string());
    std::string const level = at("my-mod/levels/1-push.json");
    write(folder / "my-mod/mod.json", "{\n  \"name\": my-mod\n}");
    for (char const* const name : {"mod.json", "interactions/push.lua"}) {
        std::string const file = at(std::string("my-mod/") + name);
        std::string const before = contentsOf(file);
        Ran const ran = run({"verify", level, "--json", file});
        EXPECT_EQ(ran.status, 2) << name;
        EXPECT_TRUE(contains(ran.err, "not overwritten") || contains(ran.err, "the file will hold"))
            << ran.err;
        EXPECT_EQ(contentsOf(file), before) << name;
    }
}

TEST_F(Mods, VerifyOfAModLooksAtItsLevelsAndTestsOnly) {
    makeMod("my-mod", folder.string());
    fs::create_directories(folder / "my-mod/parts");
    write(folder / "my-mod/parts/cube.json", R"({"name": "cube", "properties": {"mass": 1}})");
    Ran const ran = run({"verify", at("my-mod"), "--mod", folder.string()});
    EXPECT_EQ(ran.status, 0) << ran.out;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 2) << ran.out;
}

TEST_F(Mods, TheirInteractionsStandAmongTheComponents) {
    makeMod("my-mod", folder.string());
    EXPECT_FALSE(contains(run({"components"}).out, "(Dynamics <- my-mod)"));
    for (std::string const& stated : {folder.string(), at("my-mod")}) {
        Ran const ran = run({"components", "--mod", stated});
        EXPECT_EQ(ran.status, 0) << ran.err;
        EXPECT_TRUE(contains(ran.out, "(Dynamics <- my-mod) Interaction")) << stated;
    }
}

TEST_F(Mods, ALevelThatStatesScriptsAndNoModsIsReported) {
    write(at("level.json"), R"({"version": 2, "title": "a", "objects": [{"name": "b", "at": [0, 0],
        "properties": {"scripts": [{"script": "Dynamics <- Wind"}]}}]})");
    Ran const ran = run({"run", at("level.json"), "--frames", "1"});
    EXPECT_EQ(ran.status, 2);
    EXPECT_TRUE(contains(ran.err, "the level names no mod")) << ran.err;
    EXPECT_TRUE(contains(ran.err, "level.json:2:")) << ran.err;
}

} // namespace
} // namespace trembler::test
