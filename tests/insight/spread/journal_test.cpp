#include "insight/spread/journal.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <sys/stat.h>

namespace trembler::insight {
namespace {

class JournalFile : public testing::Test {
protected:
    void SetUp() override { std::filesystem::remove(file); }
    void TearDown() override { std::filesystem::remove(file); }
    void append(std::string const& text) const { std::ofstream(file, std::ios::app) << text; }

    std::filesystem::path const file = std::filesystem::temp_directory_path() / "trembler-journal-test.jsonl";
    Team team;
};

TEST_F(JournalFile, KeepsWhatIsAdded) {
    Journal(file, team).add("a", R"({"x": "quoted \" text"})");
    Journal const again(file, team);
    EXPECT_EQ(again.find("a"), R"({"x": "quoted \" text"})");
    EXPECT_FALSE(again.find("b").has_value());
}

TEST_F(JournalFile, LeavesOutALineThatWasCutOff) {
    Journal(file, team).add("a", "1");
    append(R"({"work":"b","resu)");
    Journal(file, team).add("c", "3");
    append(R"({"wo)");
    Journal const all(file, team);
    EXPECT_EQ(all.size(), 2U);
    EXPECT_EQ(all.find("a"), "1");
    EXPECT_EQ(all.find("c"), "3");
}

TEST_F(JournalFile, RefusesOtherFiles) {
    append("{\n  \"version\": 2\n}\n");
    try {
        Journal const wrong(file, team);
        FAIL() << "a level is no journal";
    } catch (std::invalid_argument const& error) {
        // Its first line, a brace, could be an entry that was cut off.
        EXPECT_NE(std::string(error.what()).find("line 2"), std::string::npos) << error.what();
    }
}

// Reading it would never end.
TEST_F(JournalFile, RefusesDevicesAndPipes) {
    std::filesystem::path const pipe = file.string() + ".pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    for (std::filesystem::path const& endless : {std::filesystem::path("/dev/full"), pipe}) {
        EXPECT_THROW(Journal(endless, team), std::invalid_argument) << endless;
    }
    std::filesystem::remove(pipe);
}

TEST_F(JournalFile, IsBoundedInItsLinesAndInSum) {
    auto const refusal = [&] {
        try {
            Journal const journal(file, team);
        } catch (std::invalid_argument const& error) {
            return std::string(error.what());
        }
        return std::string("read");
    };
    Journal(file, team).add("a", "1");
    Journal(file, team).add("b", std::string(Journal::longestLine, 'x')); // could not be read
    EXPECT_EQ(Journal(file, team).size(), 1U);
    append(R"({"work":"c","result":")" + std::string(Journal::longestLine - 24, 'x') + "\"}\n");
    EXPECT_EQ(refusal(), "read");
    append(R"({"work":"d","result":")" + std::string(Journal::longestLine - 23, 'x') + "\"}\n");
    EXPECT_EQ(refusal(), file.string() + ", line 3: has more than 1048576 bytes; expected at most 1048576");
    std::filesystem::remove(file);
    Journal(file, team).add("a", "1");
    // The files of the other members count, too. Zeros that take no room:
    std::filesystem::path const other = file.string() + ".1";
    std::ofstream(other).close();
    std::filesystem::resize_file(other, Journal::mostBytes - std::filesystem::file_size(file) + 1);
    EXPECT_NE(refusal().find("has 536870913 bytes, together with"), std::string::npos) << refusal();
    std::filesystem::remove(other);
}

} // namespace
} // namespace trembler::insight
