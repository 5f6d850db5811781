// trembler clip: an animated WebP of a run, or a message and no file.
#include "tests/game/app/program.hpp"

namespace trembler::test {
namespace {

class Clips : public InAFolder {
protected:
    [[nodiscard]] std::vector<std::string> clip(std::string const& level,
                                                std::vector<std::string> const& more) const {
        std::vector<std::string> all{"clip", level, "--out", at("it.webp"), "--size", "160x90"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

TEST_F(Clips, AreAnimatedWebpOfTheRun) {
    std::string const level = levelFile("first/1-first-contact.json").string();
    Ran const ran = runProgram(
        clip(level, {"--solution", "the steel bar", "--from", "0.5", "--seconds", "1", "--rate", "10"}));
    if (ran.err.find("without drawing") != std::string::npos) {
        GTEST_SKIP() << "a build without drawing";
    }
    ASSERT_EQ(ran.status, 0) << ran.err;
    std::string const file = contentsOf(at("it.webp"));
    ASSERT_GT(file.size(), 100U);
    EXPECT_EQ(file.substr(0, 4), "RIFF");
    EXPECT_EQ(file.substr(8, 8), "WEBPVP8X");
    std::size_t pictures = 0;
    for (std::size_t at = file.find("ANMF"); at != std::string::npos; at = file.find("ANMF", at + 4)) {
        ++pictures;
    }
    EXPECT_GT(pictures, 1U) << "something moves";
    EXPECT_LE(pictures, 10U) << "ten pictures a second for a second; equal ones are joined";
    ASSERT_EQ(runProgram(clip(level, {"--solution", "the steel bar", "--from", "0.5", "--seconds", "1",
                                      "--rate", "10"}))
                  .status,
              0);
    EXPECT_EQ(contentsOf(at("it.webp")), file) << "the same run, the same clip";
    EXPECT_EQ(names(), std::vector<std::string>{"it.webp"});
}

TEST_F(Clips, AreRefusedWithWords) {
    std::string const input = level();
    for (std::vector<std::string> const& wrong : {std::vector<std::string>{"--rate", "0"},
                                                  {"--seconds", "-1"},
                                                  {"--from", "nan"},
                                                  {"--solution", "there is no such solution"},
                                                  {"--size", "10x10"}}) {
        Ran const ran = runProgram(clip(input, wrong));
        EXPECT_NE(ran.status, 0) << wrong[0];
        EXPECT_FALSE(ran.err.empty()) << wrong[0];
    }
    EXPECT_EQ(names(), std::vector<std::string>{"level.json"});
}

} // namespace
} // namespace trembler::test
