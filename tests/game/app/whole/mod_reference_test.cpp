// trembler mod reference and annotations, and the manual for modders, followed step by step.
#include "lua/sandbox/limits.hpp"
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

#include <sstream>

namespace trembler::test {
namespace {

class ModReference : public InAFolder {};

TEST_F(ModReference, IsPrintedForPeopleForThePageAndForPrograms) {
    Ran const text = runProgram({"mod", "reference"});
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_NE(text.out.find("out.addForce(object, force)"), std::string::npos);
    EXPECT_NE(text.out.find("object.Mass\n"), std::string::npos);
    Ran const page = runProgram({"mod", "reference", "--markdown"});
    EXPECT_NE(page.out.find("### addForce\n"), std::string::npos) << page.err;
    Ran const file = runProgram({"mod", "reference", "--json", at("reference.json")});
    EXPECT_EQ(file.status, 0) << file.err;
    EXPECT_EQ(file.out, text.out) << "into a file: the text is printed as usual";
    auto const json = nlohmann::json::parse(contentsOf(at("reference.json")));
    EXPECT_GT(json["properties"].size(), 50U);
    EXPECT_EQ(runProgram({"mod", "reference", "--markdwon"}).status, 2);
}

TEST_F(ModReference, AnnotationsAreWrittenAndComeWithANewMod) {
    EXPECT_EQ(runProgram({"mod", "annotations", at("here")}).status, 0);
    std::string const annotations = contentsOf(at("here") + "/trembler.lua");
    EXPECT_EQ(annotations.rfind("---@meta trembler\n", 0), 0U);
    Ran const made = runProgram({"mod", "new", "my-mod", "--in", folder.string()});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(contentsOf(at("my-mod/annotations/trembler.lua")), annotations);
    EXPECT_TRUE(nlohmann::json::parse(contentsOf(at("my-mod/.luarc.json"))).contains("runtime.version"));
    EXPECT_EQ(runProgram({"mod", "check", at("my-mod")}).status, 0) << "annotations are no interaction";
}

/// The block of code that follows the first place of a word in the manual, without its indentation.
std::string blockAfter(std::string const& page, std::string const& word) {
    std::size_t const start = page.find("```", page.find(word));
    std::istringstream lines(page.substr(start));
    std::string block;
    std::string line;
    std::getline(lines, line); // ```lua
    while (std::getline(lines, line) && line.find("```") == std::string::npos) {
        block += line.substr(std::min<std::size_t>(3, line.size())) + "\n";
    }
    return block;
}

TEST_F(ModReference, TheManualLeadsToAModThatWorks) {
    std::string const page = contentsOf(std::filesystem::path(TREMBLER_SOURCE_DIR) / "docs/modding.md");
    ASSERT_EQ(runProgram({"mod", "new", "my-fan", "--in", folder.string()}).status, 0);
    Ran check = runProgram({"mod", "check", at("my-fan")});
    EXPECT_EQ(check.status, 0) << check.out << check.err;

    std::string script = blockAfter(page, "`my-fan/interactions/updraft.lua`");
    write(at("my-fan/interactions/updraft.lua"), script);
    write(at("my-fan/levels/2-updraft.json"), blockAfter(page, "`my-fan/levels/2-updraft.json`"));
    check = runProgram({"mod", "check", at("my-fan")});
    EXPECT_EQ(check.status, 0) << check.out << check.err;
    EXPECT_NE(check.out.find(" 0 warnings,"), std::string::npos) << check.out;
    Ran const run = runProgram({"run", at("my-fan/levels/2-updraft.json"), "--solution", "above the fan"});
    EXPECT_EQ(run.status, 0) << run.out << run.err;

    std::size_t const mistake = script.find("body.Mass");
    ASSERT_NE(mistake, std::string::npos);
    script.replace(mistake, std::string("body.Mass").size(), "body.Mas");
    write(at("my-fan/interactions/updraft.lua"), script);
    check = runProgram({"mod", "check", at("my-fan")});
    EXPECT_EQ(check.status, 1);
    EXPECT_NE(
        check.out.find(
            "updraft.lua:17: the script does not declare that it reads 'Mas' of the object (did you mean "
            "'Mass'?)"),
        std::string::npos)
        << check.out;
}

TEST_F(ModReference, TheManualStatesTheLimits) {
    std::string const page = contentsOf(std::filesystem::path(TREMBLER_SOURCE_DIR) / "docs/modding.md");
    lua::ScriptLimits const usual;
    lua::ScriptLimits const most = lua::ScriptLimits::greatest();
    auto const expectRow = [&](std::string const& key, std::size_t one, std::size_t other) {
        std::string const row =
            "| `" + key + "` | " + std::to_string(one) + " | " + std::to_string(other) + " |";
        EXPECT_NE(page.find(row), std::string::npos) << row;
    };
    expectRow("instructions", usual.instructions, most.instructions);
    expectRow("instructions_per_object", usual.instructionsPerObject, most.instructionsPerObject);
    expectRow("memory", usual.memory, most.memory);
    expectRow("calls", usual.calls, most.calls);
    expectRow("calls_per_object", usual.callsPerObject, most.callsPerObject);
    expectRow("creations", usual.creations, most.creations);
    expectRow("log_lines", usual.logLines, most.logLines);
}

} // namespace
} // namespace trembler::test
