// trembler verify --json.
#include "tests/game/app/program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace trembler::test {
namespace {

using nlohmann::json;

class VerifyCommand : public InAFolder {
protected:
    void SetUp() override {
        InAFolder::SetUp();
        write(at("wrong.json"), R"({"objects": 7})");
    }
    std::string const good = levelFile("first/1-first-contact.json").string();
};

TEST_F(VerifyCommand, WritesItsFindingsAsJson) {
    Ran const words = runProgram({"verify", good, at("wrong.json")});
    ASSERT_EQ(words.status, 1) << words.err;
    Ran const printed = runProgram({"verify", good, at("wrong.json"), "--json"});
    EXPECT_EQ(printed.status, 1) << printed.err;
    json const all = json::parse(printed.out);
    EXPECT_EQ(all["valid"], false);
    ASSERT_EQ(all["levels"].size(), 2U) << printed.out;
    EXPECT_EQ(
        all["levels"][0],
        json::parse(R"({"level": "levels/first/1-first-contact.json", "valid": true, "failures": []})"));
    EXPECT_EQ(all["levels"][1]["valid"], false);
    EXPECT_FALSE(all["levels"][1]["failures"].empty());
    // Into a file: the words are printed as usual.
    EXPECT_EQ(runProgram({"verify", good, at("wrong.json"), "--json", at("report.json")}).out, words.out);
    EXPECT_EQ(contentsOf(at("report.json")), printed.out);
}

TEST_F(VerifyCommand, GoesOnWithWhatItHasVerified) {
    Ran const first = runProgram({"verify", good, at("wrong.json"), "--resume", at("all.jsonl")});
    EXPECT_EQ(first.status, 1) << first.err;
    std::string const journal = contentsOf(at("all.jsonl"));
    EXPECT_EQ(std::count(journal.begin(), journal.end(), '\n'), 2);
    Ran const again = runProgram({"verify", good, at("wrong.json"), "--resume", at("all.jsonl")});
    EXPECT_EQ(again.out, first.out);
    EXPECT_EQ(contentsOf(at("all.jsonl")), journal) << "nothing was verified twice";
    // A level that was changed since then is verified again.
    std::filesystem::copy_file(good, at("wrong.json"), std::filesystem::copy_options::overwrite_existing);
    Ran const mended = runProgram({"verify", good, at("wrong.json"), "--resume", at("all.jsonl")});
    EXPECT_EQ(mended.status, 0) << mended.out << mended.err;
    std::string const more = contentsOf(at("all.jsonl"));
    EXPECT_EQ(std::count(more.begin(), more.end(), '\n'), 3);
    EXPECT_EQ(more.substr(0, journal.size()), journal);
}

TEST_F(VerifyCommand, TakesNoLevelForTheFileToWrite) {
    // Without another PATH the name after the option is the PATH.
    Ran const one = runProgram({"verify", "--json", good});
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_EQ(json::parse(one.out)["valid"], true);
    // With another one it would be the FILE.
    std::string const before = contentsOf(at("wrong.json"));
    Ran const two = runProgram({"verify", "--json", at("wrong.json"), good});
    EXPECT_EQ(two.status, 2);
    EXPECT_NE(two.err.find("not overwritten"), std::string::npos) << two.err;
    EXPECT_EQ(contentsOf(at("wrong.json")), before);
}

} // namespace
} // namespace trembler::test
