// Files that exceed limits are rejected before they use much time or memory.
#include "runtime/level/json/limits.hpp"
#include "tests/game/app/program.hpp"

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

} // namespace
} // namespace trembler::test
