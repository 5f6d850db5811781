// Files that exceed limits are rejected before they use much time or memory.
#include "runtime/level/json/limits.hpp"
#include "tests/game/app/program.hpp"

#include <fmt/format.h>

namespace trembler::test {
namespace {

class Limits : public InAFolder {};

constexpr std::size_t enough = std::size_t{1200} << 20U; // bytes, including the overhead of a sanitizer

TEST_F(Limits, OfAFilesSize) {
    write(at("level.json"), "[");
    std::filesystem::resize_file(at("level.json"), std::size_t{200} << 20U);
    Ran const ran = runProgram({"run", at("level.json")});
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.err.find("has 209715200 bytes; expected at most 67108864"), std::string::npos) << ran.err;
    EXPECT_LT(ran.mostMemory, enough / 4);
}

TEST_F(Limits, OfItsValues) {
    for (std::string const& entry : {std::string("1,"), std::string("{},")}) {
        std::string text = "[";
        while (text.size() < limits::fileSize / 4) {
            text += entry;
        }
        text += "1]";
        write(at("level.json"), text);
        Ran const ran = runProgram({"run", at("level.json")});
        EXPECT_EQ(ran.status, 2);
        EXPECT_NE(ran.err.find("too many values; expected at most 4000000"), std::string::npos) << ran.err;
        EXPECT_LT(ran.mostMemory, enough) << entry;
    }
    std::string twice = "{";
    while (twice.size() < (std::size_t{8} << 20U)) {
        twice += "\"a\":1,";
    }
    write(at("level.json"), twice + "\"a\":1}");
    Ran const ran = runProgram({"run", at("level.json")});
    EXPECT_EQ(ran.status, 2);
    EXPECT_LT(std::count(ran.err.begin(), ran.err.end(), '\n'), 110);
}

// Ten thousand conditions, each of which names about ten thousand objects twice: a small file.
TEST_F(Limits, OfTheObjectsOfGoals) {
    constexpr int many = 10'000;
    std::string objects;
    std::string goals;
    for (int i = 0; i < many; ++i) {
        objects += fmt::format(R"({}{{"name": "ball {}", "part": "wooden ball", "at": [{}, 0]}})",
                               i == 0 ? "" : ",\n", i, i);
        if (i + 1 < many) { // the list of them is a condition, too
            goals +=
                fmt::format(R"({}{{"touching": [{{"part": "wooden ball"}}, {{"part": "wooden ball"}}]}})",
                            i == 0 ? "" : ",\n", i);
        }
    }
    write(at("level.json"), R"({"version": 2, "title": "many", "objects": [)" + objects +
                                R"(], "goals": {"all": [)" + goals + "]}}");
    Ran const ran = runProgram({"run", at("level.json"), "--frames", "1"});
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.err.find("the goals speak of too many objects"), std::string::npos) << ran.err;
    EXPECT_LT(ran.mostMemory, enough);
}

} // namespace
} // namespace trembler::test
