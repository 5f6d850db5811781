#include "puzzle/data/game_data.hpp"
#include "puzzle/data/own_part_files.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace trembler {
namespace {

TEST(OwnPartFiles, AreAddedEachByItself) {
    GameData const data;
    auto const folder = std::filesystem::path(testing::TempDir()) / "own_part_files";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    auto const write = [&](char const* name, char const* text) { std::ofstream(folder / name) << text; };
    // The part consists of a part whose file comes later.
    write(
        "a.json",
        R"({"name": "own pair", "objects": [{"name": "one", "part": "own disc"}, {"name": "two", "part": "own disc", "at": [1, 0]}]})");
    write(
        "b.json",
        R"({"name": "own disc", "properties": {"material": "wood", "shape": [{"form": "circle", "radius": 0.1}]}})");
    write("c.json", R"({"name": "plank", "properties": {"material": "wood"}})");
    write("d.json", R"({"name": )");
    write("e.json", R"({"name": "own nothing", "objects": [{"name": "one", "part": "no such part"}]})");
    write("f.txt", "no part");
    PartLibrary library = data.parts;
    auto const faults = addOwnParts(data.registry, folder, library);
    EXPECT_NE(library.find("own pair"), nullptr);
    EXPECT_NE(library.find("own disc"), nullptr);
    EXPECT_EQ(library.find("own nothing"), nullptr);
    EXPECT_EQ(library.all().size(), data.parts.all().size() + 2);
    ASSERT_EQ(faults.size(), 3U);
    EXPECT_NE(faults[0].file.find("d.json"), std::string::npos);
    EXPECT_NE(faults[1].print().find("c.json"), std::string::npos);
    EXPECT_NE(faults[1].message.find("plank.json"), std::string::npos) << "both files are named";
    EXPECT_NE(faults[2].print().find("e.json"), std::string::npos);
    EXPECT_TRUE(addOwnParts(data.registry, folder / "none", library).empty());
}

TEST(OwnPartFiles, OfDamagedOnesTheLastGoodVersionIsTakenAndNothingIsMoved) {
    GameData const data;
    auto const folder = std::filesystem::path(testing::TempDir()) / "damaged_part_files";
    std::filesystem::remove_all(folder);
    KeptFile const disc(folder / "disc.json");
    for (char const* const density : {"500", "600"}) {
        disc.write(std::string(R"({"name": "own disc", "properties": {"density": )") + density + "}}");
    }
    std::ofstream(folder / "cut.json") << R"({"name": )";
    std::filesystem::resize_file(disc.path(), 10);
    PartLibrary library = data.parts;
    std::vector<DamagedFile> damaged;
    auto const faults = addOwnParts(data.registry, folder, library, ownPartLimits, &damaged);
    EXPECT_NE(library.find("own disc"), nullptr);
    ASSERT_EQ(damaged.size(), 2U);
    EXPECT_EQ(damaged[0].file, folder / "cut.json");
    EXPECT_FALSE(damaged[0].lastTaken);
    EXPECT_EQ(damaged[1].file, folder / "disc.json");
    EXPECT_TRUE(damaged[1].lastTaken);
    ASSERT_EQ(faults.size(), 1U) << "of the one without a good version";
    EXPECT_NE(faults[0].print().find("cut.json:1:"), std::string::npos)
        << "with the place: " << faults[0].print();
    EXPECT_EQ(std::filesystem::file_size(disc.path()), 10U);
    EXPECT_FALSE(std::filesystem::exists(folder / "disc.json.damaged-1"));
}

} // namespace
} // namespace trembler
