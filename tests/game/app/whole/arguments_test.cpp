// Command-line arguments that were once misinterpreted.
#include "tests/game/app/program.hpp"

namespace trembler::test {
namespace {

class Arguments : public InAFolder {};

TEST_F(Arguments, AreDecimalNumbersInTheirRanges) {
    std::string const input = level();
    for (auto const& [option, value] :
         std::vector<std::pair<std::string, std::string>>{{"--frames", "010"},
                                                          {"--frames", "0x10"},
                                                          {"--frames", "0"},
                                                          {"--frames", "-1"},
                                                          {"--frames", "10000001"}, // too many frames
                                                          {"--frames", "18446744073709551617"},
                                                          {"--frames", "1e2"},
                                                          {"--frames", " 7"},
                                                          {"--frames", "+7"},
                                                          {"--frames", ""},
                                                          {"--hash-every", "-1"},
                                                          {"--hash-every", "0"},
                                                          {"--threads", "02"},
                                                          {"--threads", "257"},
                                                          {"--substeps", "65"},
                                                          {"--substeps", "1.5"},
                                                          {"--period", "Dynamics Resolver=010"},
                                                          {"--period", "Dynamics Resolver=0"},
                                                          {"--period", "Dynamics Resolver=3601"},
                                                          {"--budget", "nan"},
                                                          {"--budget", "inf"},
                                                          {"--budget", "0"},
                                                          {"--budget", "1e4"},
                                                          {"--budget", "2ms"}}) {
        Ran const ran = runProgram({"run", input, option, value});
        EXPECT_EQ(ran.status, 2) << option << " " << value;
        EXPECT_NE(ran.err.find(option), std::string::npos) << ran.err;
    }
    EXPECT_EQ(runProgram({"run", input, "--frames", "10", "--hash-every", "5", "--threads", "2", "--substeps",
                          "0", "--period", "Dynamics Resolver=2"})
                  .status,
              1);
    for (char const* const size : {"0100x100", "100", "100x", "x100", "100x100x", "15x100", "16385x16",
                                   "8193x8192", " 99x99", "1e3x99"}) {
        Ran const ran = runProgram({"screenshot", input, "--out", at("picture.png"), "--size", size});
        EXPECT_EQ(ran.status, 2) << size;
    }
    EXPECT_EQ(runProgram({"screenshot", input, "--out", at("picture.png"), "--frame", "010"}).status, 2);
    EXPECT_EQ(runProgram({"accuracy", "gravity", "--brief", "--runs", "01"}).status, 2);
    EXPECT_EQ(names(), std::vector<std::string>{"level.json"});
}

TEST_F(Arguments, NameALevel) {
    Ran const ran = runProgram({"run", "--frames", "10"});
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.err.find("LEVEL is required"), std::string::npos) << ran.err;
}

TEST_F(Arguments, OfVerifyHoldLevels) {
    Ran const empty = runProgram({"verify", folder.string()});
    EXPECT_EQ(empty.status, 2);
    EXPECT_NE(empty.err.find("no level"), std::string::npos) << empty.err;
    Ran const one = runProgram({"verify", levelFile("first/1-first-contact.json").string()});
    EXPECT_EQ(one.status, 0) << one.out;
    EXPECT_EQ(one.out, "levels/first/1-first-contact.json: valid\n");
    EXPECT_EQ(
        runProgram({"verify", levelFile("first/1-first-contact.json").string(), folder.string()}).status, 2);
}

TEST_F(Arguments, ThatCannotBeReadAreReportedWithTheReason) {
    Ran const none = runProgram({"run", at("none.json")});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("No such file or directory"), std::string::npos) << none.err;
    Ran const unverified = runProgram({"verify", at("none.json")});
    EXPECT_EQ(unverified.status, 2);
    EXPECT_EQ(unverified.out, "");
    EXPECT_NE(unverified.err.find("none.json: cannot be read: No such file or directory"), std::string::npos)
        << unverified.err;
    write(at("a file"), "");
    Ran const inside = runProgram({"run", at("a file/level.json")});
    EXPECT_NE(inside.err.find("Not a directory"), std::string::npos) << inside.err;
    Ran const device = runProgram({"run", "/proc/self/mem"}); // exists, but reading its beginning fails
    EXPECT_EQ(device.status, 2);
}

} // namespace
} // namespace trembler::test
