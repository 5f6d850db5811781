#include "runtime/file/path_text.hpp"
#include "runtime/file/visible_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace trembler {
namespace {

TEST(PathText, LeavesUtf8AsItIs) {
    for (char const* const path : {"", "/home/someone/level.json", "/tmp/Übung €/𝄞.json"}) {
        EXPECT_EQ(pathAsText(path), path);
        EXPECT_EQ(pathFromText(path), path);
    }
}

TEST(PathText, ComesBackFromJsonWhateverTheBytesAre) {
    std::string every;
    for (int byte = 1; byte < 256; ++byte) {
        every += static_cast<char>(byte);
    }
    for (std::string const& path :
         {std::string("l\xe4vel.json"), std::string("l\xc3"), std::string("\xff\xfe/\xed\xa0\x80"), every}) {
        std::string const stored = nlohmann::json(pathAsText(path)).dump(); // throws at what is not UTF-8
        EXPECT_EQ(pathFromText(nlohmann::json::parse(stored).get<std::string>()), path);
    }
    EXPECT_NE(pathAsText("l\xe4"), pathAsText("l\xf6"));
}

TEST(PathText, OfNoPathIsKept) {
    using namespace std::string_literals;
    for (std::string const& text : {"\0"s, "a\0x1"s, "a\0"s, "\0e"s}) {
        EXPECT_EQ(pathFromText(text), text);
    }
}

} // namespace
} // namespace trembler
