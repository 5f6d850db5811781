// Which of the installed mods free play offers: those with parts that can be loaded together.
#include "puzzle/campaign/free_play.hpp"
#include "puzzle/data/offered_mods.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace trembler {
namespace offered_mods_test {
namespace {

namespace fs = std::filesystem;

class Offered : public testing::Test {
protected:
    Offered() {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }

    void install(std::string const& bundled) const {
        fs::copy(fs::path(TREMBLER_SOURCE_DIR) / "mods" / bundled, folder / bundled,
                 fs::copy_options::recursive);
    }
    /// A mod of one part.
    void make(std::string const& name, std::string const& part, std::string const& needs = "") const {
        fs::create_directories(folder / name / "parts");
        std::ofstream(folder / name / "mod.json")
            << R"({"name": ")" << name
            << R"(", "version": "1", "author": "a", "licence": "CC0-1.0", "needs": [)" << needs << "]}";
        std::ofstream(folder / name / "parts" / "part.json") << part;
    }
    [[nodiscard]] static std::string ball(std::string const& name) {
        return R"({"name": ")" + name +
               R"(", "properties": {"material": "wood", "shape": [{"form": "circle", "radius": 0.1}]}})";
    }
    [[nodiscard]] OfferedMods offered() {
        std::vector<fs::path> const folders{folder};
        return offeredMods(lua::listMods(folders), [&](std::vector<std::string> const& names) {
            ++loads;
            Problems problems;
            auto mods = lua::findMods(names, folders, "", problems);
            problems.throwIfAny();
            return std::make_shared<GameData const>(std::move(mods));
        });
    }

    fs::path const folder = fs::path(TREMBLER_BINARY_DIR) / "offered-mods" /
                            testing::UnitTest::GetInstance()->current_test_info()->name();
    int loads = 0;
};

TEST_F(Offered, NoneAreInstalled) {
    OfferedMods const mods = offered();
    EXPECT_EQ(mods.data, nullptr);
    EXPECT_TRUE(mods.names.empty());
    EXPECT_EQ(loads, 0);
}

TEST_F(Offered, BringTheirPartsAndTheLevelOfFreePlayNamesThem) {
    install("wind");
    install("tap");
    make("of-mine", ball("my ball"));
    fs::create_directories(folder / "without-parts");
    std::ofstream(folder / "without-parts" / "mod.json")
        << R"({"name": "without-parts", "version": "1", "author": "a", "licence": "CC0-1.0"})";
    OfferedMods const mods = offered();
    EXPECT_EQ(loads, 1) << "all at once";
    EXPECT_EQ(mods.names, (std::vector<std::string>{"of-mine", "tap", "wind"}));
    EXPECT_TRUE(mods.leftOut.empty());
    ASSERT_NE(mods.data, nullptr);
    LevelFile const level = readLevel(
        mods.data->registry,
        JsonDocument::parse(freePlayLevel(mods.data->parts, "Free", "", {}, mods.names), "free.json"));
    EXPECT_EQ(level.mods, mods.names);
    for (char const* const part : {"fan", "drain", "my ball", "lamp"}) {
        EXPECT_EQ(std::count_if(level.toolbox.begin(), level.toolbox.end(),
                                [&](ToolboxEntry const& entry) { return entry.part == part; }),
                  1)
            << part;
    }
}

TEST_F(Offered, LeaveOutWhatIsWrongAndSayWhy) {
    install("wind");
    make("a-broken", R"({"name": "hole", "properties": {"material": "cheese"}})");
    make("b-another-lamp", ball("lamp"));
    make("c-needy", ball("needy ball"), R"("nowhere")");
    make("d-good", ball("good ball"));
    fs::copy(folder / "wind", folder / "x-script", fs::copy_options::recursive);
    std::ofstream(folder / "x-script" / "mod.json")
        << R"({"name": "x-script", "version": "1", "author": "a", "licence": "CC0-1.0"})";
    std::ofstream(folder / "x-script" / "interactions" / "wind.lua") << "return interaction {";
    OfferedMods const mods = offered();
    EXPECT_EQ(mods.names, (std::vector<std::string>{"d-good", "wind"}));
    ASSERT_NE(mods.data, nullptr);
    EXPECT_NE(mods.data->parts.find("good ball"), nullptr);
    EXPECT_NE(mods.data->parts.find("fan"), nullptr);
    EXPECT_EQ(mods.data->parts.find("needy ball"), nullptr);
    ASSERT_EQ(mods.leftOut.size(), 4U);
    EXPECT_EQ(mods.leftOut[0].name, "a-broken");
    EXPECT_NE(mods.leftOut[0].fault.print().find("cheese"), std::string::npos)
        << mods.leftOut[0].fault.print();
    EXPECT_EQ(mods.leftOut[1].name, "b-another-lamp");
    EXPECT_EQ(mods.leftOut[2].name, "c-needy");
    EXPECT_NE(mods.leftOut[2].fault.print().find("nowhere"), std::string::npos);
    EXPECT_EQ(mods.leftOut[3].name, "x-script");
}

TEST_F(Offered, NoneIsRight) {
    make("broken", "{");
    OfferedMods const mods = offered();
    EXPECT_EQ(mods.data, nullptr);
    EXPECT_TRUE(mods.names.empty());
    EXPECT_EQ(mods.leftOut.size(), 1U);
}

} // namespace
} // namespace offered_mods_test
} // namespace trembler
