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
