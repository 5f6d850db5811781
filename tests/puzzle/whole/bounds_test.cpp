// The bounds of what files may make the program hold: just below each one a file is accepted, beyond it the
// message names the file, its size and the limit.
#include "lua/mods/mod.hpp"
#include "puzzle/campaign/progress.hpp"
#include "puzzle/data/own_part_files.hpp"
#include "runtime/level/json/json_node.hpp"
#include "runtime/level/json/read_text.hpp"
#include "runtime/level/json/text_limits.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/support/game_data.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace trembler {
namespace bounds_test {
namespace {

namespace fs = std::filesystem;

class Bounds : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::path(testing::TempDir()) / ("bounds " + std::to_string(getpid()));
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    void write(fs::path const& file, std::string const& content) const {
        fs::create_directories((folder / file).parent_path());
        std::ofstream(folder / file, std::ios::binary) << content;
    }
    /// A file of zeros that takes no room.
    void writeSparse(fs::path const& file, std::uintmax_t size) const {
        write(file, "");
        fs::resize_file(folder / file, size);
    }
    /// The messages of a reader, each "message; expected"; "read" if there are none.
    static std::string said(std::function<void()> const& read) {
        try {
            read();
        } catch (InputError const& error) {
            return said(error.diagnostics());
        }
        return "read";
    }
    static std::string said(std::vector<Diagnostic> const& problems) {
        std::string all;
        for (Diagnostic const& problem : problems) {
            EXPECT_FALSE(problem.file.empty());
            all += (all.empty() ? "" : " | ") + problem.message +
                   (problem.expected.empty() ? "" : "; expected " + problem.expected);
        }
        return all.empty() ? "read" : all;
    }
    [[nodiscard]] std::string readLevelText(std::string const& key, nlohmann::json const& value) const {
        nlohmann::json level{{"version", 2}, {"title", "t"}, {"objects", nlohmann::json::array()}};
        level[key] = value;
        return said(
            [&] { (void)readLevel(gameData().registry, JsonDocument::parse(level.dump(), "f.json")); });
    }

    fs::path folder;
};

TEST_F(Bounds, OfTextsInALevel) {
    std::string const most(limits::text, 'x');
    std::string const tooMuch = most + "x";
    std::string const refusal = "has 100001 bytes; expected at most 100000";
    EXPECT_EQ(readLevelText("text", most), "read");
    EXPECT_EQ(readLevelText("text", tooMuch), refusal);
    EXPECT_EQ(readLevelText("hints", {most}), "read");
    EXPECT_EQ(readLevelText("hints", {tooMuch}), refusal);
    EXPECT_EQ(readLevelText("texts", {{"de", {{"text", tooMuch}}}}), refusal);
    EXPECT_EQ(readLevelText("texts", {{"de", {{"hints", {tooMuch}}}}}), refusal);
    EXPECT_EQ(readLevelText("texts", {{"de", {{"goals", {{"g", tooMuch}}}}}}), refusal);
}

TEST_F(Bounds, OfKeysAndOfWhatAMessageQuotes) {
    auto const parsed = [&](std::string const& text) {
        return said([&] { (void)JsonDocument::parse(text, "f.json"); });
    };
    std::string const key(limits::key, 'k');
    EXPECT_EQ(parsed("{\"" + key + "\": 1}"), "read");
    EXPECT_EQ(parsed("{\"a\": {\"b\": 2, \"" + key + "k\": 1}}"),
              "has a key of 1001 bytes; expected at most 1000");
    // A value of a megabyte that never ends, and one in the wrong place.
    for (std::string const& text :
         {"{\"a\": \"" + std::string(1'000'000, 'x'), "[1 \"" + std::string(1'000'000, 'x') + "\"]"}) {
        EXPECT_LT(parsed(text).size(), 500U);
        EXPECT_NE(parsed(text).find("syntax error"), std::string::npos);
    }
}

TEST_F(Bounds, OfAFileThatIsReadWhole) {
    writeSparse("large", 5'000'000'000);
    write("right", "0123456789");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    struct Case {
        fs::path file;
        std::size_t most;
        std::string expected;
    };
    for (Case const& one :
         {Case{folder / "right", 10, "read"}, Case{folder / "right", 9, "has 10 bytes; expected at most 9"},
          Case{folder / "large", 1000, "has 5000000000 bytes; expected at most 1000"},
          Case{folder, 1000, "is a folder; expected a file"}}) {
        EXPECT_EQ(said([&] { (void)readText(one.file, one.most); }), one.expected) << one.file;
    }
    for (fs::path const& endless : {folder / "pipe", fs::path("/dev/zero")}) {
        EXPECT_NE(said([&] { (void)readText(endless, 1000); }).find("is no ordinary file"),
                  std::string::npos);
    }
    EXPECT_EQ(said([&] { (void)JsonDocument::load(folder / "large"); }),
              "has 5000000000 bytes; expected at most 67108864");
}

TEST_F(Bounds, OfPartsInAFolder) {
    Registry const& registry = gameData().registry;
    std::size_t bytes = 0;
    for (int i = 0; i < 5; ++i) {
        std::string const part =
            fmt::format(R"({{"name": "part {}", "properties": {{"material": "wood"}}}})", i);
        write(fmt::format("parts/{}.json", i), part);
        bytes += part.size();
    }
    fs::path const parts = folder / "parts";
    struct Case {
        PartLimits most;
        std::string expected;
        std::size_t own; ///< parts that are added to the player's nevertheless
    };
    for (Case const& one : {Case{{.files = 5, .bytes = bytes}, "read", 5},
                            Case{{.files = 4, .bytes = bytes}, "has 5 files of parts; expected at most 4", 4},
                            Case{{.files = 5, .bytes = bytes - 1},
                                 fmt::format("its files of parts have {} bytes together; expected at most {}",
                                             bytes, bytes - 1),
                                 0}}) {
        EXPECT_EQ(said([&] { (void)loadParts(registry, parts, one.most); }), one.expected);
        PartLibrary library;
        EXPECT_EQ(said(addOwnParts(registry, parts, library, one.most)), one.expected);
        EXPECT_EQ(library.all().size(), one.own);
    }
}

TEST_F(Bounds, OfMods) {
    auto const mod = [&](std::string const& name, std::vector<std::string> const& needs) {
        write("mods/" + name + "/mod.json",
              nlohmann::json{
                  {"name", name}, {"version", "1"}, {"author", "a"}, {"licence", "l"}, {"needs", needs}}
                  .dump());
    };
    for (int i = 0; i < 120; ++i) { // a chain, of which a level needs as much as it names
        mod(fmt::format("m{}", i),
            i < 119 ? std::vector<std::string>{fmt::format("m{}", i + 1)} : std::vector<std::string>());
    }
    std::vector<fs::path> const folders{folder / "mods"};
    auto const found = [&](std::string const& name) {
        return said([&] {
            Problems problems;
            (void)lua::findMods(std::vector<std::string>{name}, folders, "level.json", problems);
            problems.throwIfAny();
        });
    };
    EXPECT_EQ(found("m20"), "read") << "a hundred mods";
    EXPECT_EQ(found("m19"), "the level and its mods need more than 100 mods; expected at most 100");

    for (int i = 0; i < 51; ++i) {
        write(fmt::format("mods/m119/interactions/{}.lua", i), "return 1");
    }
    EXPECT_EQ(found("m119"), "51 interactions; expected at most 50");
    fs::remove_all(folder / "mods/m119/interactions");
    writeSparse("mods/m119/interactions/a.lua", 5'000'000'000);
    EXPECT_EQ(found("m119"), "has 5000000000 bytes; expected at most 65536");

    for (int i = 0; i < 1000; ++i) {
        write(fmt::format("many/x{:04}/mod.json", i), "{}");
    }
    write("many/a/mod.json", "{}");
    auto const listed = lua::listMods(std::vector<fs::path>{folder / "many"});
    ASSERT_EQ(listed.size(), 1000U);
    EXPECT_EQ(listed.front().filename(), "a") << "the first by name";
    EXPECT_EQ(listed.back().filename(), "x0998");
}

TEST_F(Bounds, OfThePartsOfAllModsOfALevel) {
    std::string const spaces(std::size_t{25} << 20U, ' ');
    std::vector<lua::Mod> mods;
    Problems problems;
    for (std::string const name : {"one", "three", "two"}) {
        write(
            "mods/" + name + "/mod.json",
            nlohmann::json{{"name", name}, {"version", "1"}, {"author", "a"}, {"licence", "l"}, {"text", "t"}}
                .dump());
        write("mods/" + name + "/parts/it.json",
              R"({"name": "part of )" + name + R"(", "properties": {"material": "wood"}})" + spaces);
        mods.push_back(lua::readMod(folder / "mods" / name, problems));
    }
    problems.throwIfAny();
    EXPECT_EQ(said([&] { (void)GameData({mods[0], mods[1]}); }), "read");
    std::string const refusal = said([&] { (void)GameData(mods); });
    EXPECT_EQ(refusal.find("its files of parts and those of the other mods have 786"), 0U) << refusal;
    EXPECT_NE(refusal.find("bytes together; expected at most 67108864"), std::string::npos) << refusal;
}

TEST_F(Bounds, OfKindsOfSolutionInAProfile) {
    nlohmann::ordered_json kinds = nlohmann::ordered_json::array();
    for (int i = 0; i < 1010; ++i) {
        kinds.push_back({{"parts", {fmt::format("part {}", i)}}});
    }
    CampaignProgress progress;
    progress.read({{"level.json", {{"kinds", kinds}}}});
    EXPECT_EQ(progress.of("level.json").kinds.size(), 1000U);
}

} // namespace
} // namespace bounds_test
} // namespace trembler
