// trembler keys: lists every command of the window, as docs/players.md does.
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

namespace trembler::test {
namespace {

class ProgramKeys : public InAFolder {};

TEST_F(ProgramKeys, ArePrintedForPeopleAndForThePage) {
    Ran const text = runProgram({"keys"});
    if (text.err.find("without the window") != std::string::npos) {
        EXPECT_EQ(text.status, 2);
        GTEST_SKIP() << "this build has no window";
    }
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_NE(text.out.find("redo"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("Ctrl+Shift+Z, Ctrl+Y"), std::string::npos) << text.out;
    Ran const page = runProgram({"keys", "--markdown"});
    EXPECT_EQ(page.status, 0) << page.err;
    EXPECT_NE(page.out.find("| Redo | `Ctrl+Shift+Z`, `Ctrl+Y`, `Pad R1` | `redo` |"), std::string::npos)
        << page.out;
    EXPECT_EQ(runProgram({"keys", "--markdown", at("keys.md")}).status, 0);
    EXPECT_EQ(contentsOf(at("keys.md")), page.out);
    Ran const mouse = runProgram({"keys", "--mouse"});
    EXPECT_EQ(mouse.status, 0) << mouse.err;
    EXPECT_NE(mouse.out.find("| move a part | drag |"), std::string::npos) << mouse.out;
    Ran const list = runProgram({"keys", "--json"});
    EXPECT_EQ(list.status, 0) << list.err;
    bool redo = false;
    nlohmann::json const keys = nlohmann::json::parse(list.out);
    for (nlohmann::json const& command : keys.at("commands")) {
        if (command["id"] == "redo") {
            redo = true;
            EXPECT_EQ(command["keys"], (std::vector<std::string>{"Ctrl+Shift+Z", "Ctrl+Y", "Pad R1"}));
        }
    }
    EXPECT_TRUE(redo) << list.out;
    // Into a file: the text is printed as usual.
    EXPECT_EQ(runProgram({"keys", "--json", at("keys.json")}).out, text.out);
    EXPECT_EQ(contentsOf(at("keys.json")), list.out);
    EXPECT_EQ(runProgram({"keys", "--jsno"}).status, 2);
}

} // namespace
} // namespace trembler::test
