// The texts of the screens: complete in every language, none unused.
#include "game/ui/shared/texts.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> textsIn(std::string_view language) {
    std::ifstream in(fs::path(TREMBLER_SOURCE_DIR) / "assets/text" / (std::string(language) + ".json"));
    return nlohmann::json::parse(in).get<std::map<std::string, std::string>>();
}

/// Every id that a source of the window's mentions, as a string of its own.
std::set<std::string> mentioned(std::map<std::string, std::string> const& known) {
    std::set<std::string> ids;
    std::regex const call(R"re(\btext(?:With)?\("([a-z_]+\.[a-z_.]+)")re");
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(TREMBLER_SOURCE_DIR) / "game/ui")) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") {
            continue;
        }
        std::ifstream in(entry.path());
        std::string const source(std::istreambuf_iterator<char>(in), {});
        for (std::sregex_iterator at(source.begin(), source.end(), call), end; at != end; ++at) {
            ids.insert((*at)[1]);
        }
        for (auto const& [id, value] : known) { // also where a function passes it on
            if (source.find("\"" + id + "\"") != std::string::npos) {
                ids.insert(id);
            }
        }
    }
    return ids;
}

TEST(Texts, EveryTextIsThereAndUsed) {
    auto const english = textsIn("en");
    std::set<std::string> known;
    for (auto const& [id, value] : english) {
        known.insert(id);
        EXPECT_FALSE(value.empty()) << id;
    }
    EXPECT_EQ(mentioned(english), known) << "a text is missing in assets/text/en.json, or not used any more";
}

TEST(Texts, EveryLanguageHasAllOfThem) {
    auto const english = textsIn("en");
    for (Language const& language : languages()) {
        auto const texts = textsIn(language.id);
        for (auto const& [id, value] : english) {
            auto const found = texts.find(id);
            ASSERT_NE(found, texts.end()) << language.id << " lacks " << id;
            auto const gaps = [](std::string const& of) { return std::count(of.begin(), of.end(), '{'); };
            EXPECT_EQ(gaps(found->second), gaps(value)) << language.id << ": " << id;
        }
        EXPECT_EQ(texts.size(), english.size()) << language.id << " has texts that English lacks";
    }
}

TEST(Texts, FollowTheLanguage) {
    useLanguage("de");
    EXPECT_EQ(languageInUse(), "de");
    EXPECT_STREQ(text("menu.back"), "Zurück");
    EXPECT_EQ(textWith("builds.not_kept", "x"), "Was du gebaut hast, lässt sich nicht aufheben: x");
    useLanguage("en");
    EXPECT_STREQ(text("menu.back"), "Back");
    EXPECT_STREQ(text("no.such.text"), "no.such.text");
}

} // namespace
} // namespace trembler::ui
