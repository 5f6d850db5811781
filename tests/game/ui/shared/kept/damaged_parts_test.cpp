// Damaged files of own parts are treated as the player's other files, and the part can still be used.
#include "game/ui/shared/kept/damaged_parts.hpp"
#include "puzzle/data/game_data.hpp"
#include "tests/game/ui/edit/editor_kit.hpp"
#include "tests/support/variable.hpp"

#include <fstream>

namespace trembler::ui::test {
namespace {

namespace fs = std::filesystem;

std::string partNamed(std::string const& name) {
    return R"({"name": ")" + name +
           R"(", "properties": {"material": "wood", "shape": [{"form": "circle", "radius": 0.1}]}})";
}

TEST(DamagedParts, AreMovedAsideAndReportedInTheWindowOnce) {
    fs::path const data = testFolder() / "damaged parts";
    fs::remove_all(data);
    trembler::test::Variable const environment("XDG_DATA_HOME", data.c_str());
    fs::path const folder = ownPartsFolder();
    ASSERT_EQ(folder, data / "trembler" / "parts");
    KeptFile const withLast(folder / "disc.json");
    withLast.write(partNamed("own disc"));
    withLast.write(partNamed("own disc") + "\n");
    for (char const* const name : {"disc.json", "cut.json"}) {
        std::ofstream(folder / name) << "{\"name\": ";
    }
    GameData const game;
    EXPECT_NE(game.parts.find("own disc"), nullptr) << "the last good version";
    ASSERT_EQ(game.damagedOwnParts.size(), 2U);
    EXPECT_TRUE(fs::exists(folder / "disc.json~"));
    EXPECT_FALSE(fs::exists(folder / "disc.json.damaged-1")) << "reading alone moves nothing";
    std::vector<std::string> const said = moveDamagedAside(game.damagedOwnParts);
    ASSERT_EQ(said.size(), 2U);
    EXPECT_NE(said[0].find("cut.json.damaged-1"), std::string::npos) << said[0];
    EXPECT_NE(said[0].find("no earlier version"), std::string::npos) << said[0];
    EXPECT_NE(said[1].find("disc.json.damaged-1"), std::string::npos) << said[1];
    EXPECT_NE(said[1].find("last good version"), std::string::npos) << said[1];
    EXPECT_EQ(textOfFile(folder / "disc.json"), partNamed("own disc"));
    EXPECT_EQ(textOfFile(folder / "cut.json.damaged-1"), "{\"name\": ");
    EXPECT_TRUE(moveDamagedAside(game.damagedOwnParts).empty());
    GameData const again;
    EXPECT_TRUE(again.damagedOwnParts.empty());
    EXPECT_TRUE(again.ownPartFaults.empty());
    EXPECT_NE(again.parts.find("own disc"), nullptr);
    fs::remove_all(data);
}

} // namespace
} // namespace trembler::ui::test
