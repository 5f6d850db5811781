// The groups of parts: every part has one, and a part that nobody has listed anywhere is where it belongs.
#include "puzzle/data/part_groups.hpp"
#include "runtime/level/read/read_part.hpp"
#include "tests/support/game_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler {
namespace part_groups_test {
namespace {

using Groups = std::vector<PartGroup>;

/// The program's parts and one more, which consists of these members.
Groups groupsOfNew(std::string const& members) {
    PartLibrary library = gameData().parts;
    library.add(readPart(gameData().registry,
                         JsonDocument::parse(R"({"name": "new", )" + members + "}", "new.json")));
    return groupsOf(library, "new");
}

std::string box(std::string const& properties) {
    return R"("shape": [{"form": "box", "width": 1, "height": 1}], )" + properties;
}

TEST(PartGroups, EveryPartHasOneInOrder) {
    for (std::string const& part : gameData().parts.names()) {
        Groups const groups = groupsOf(gameData().parts, part);
        EXPECT_FALSE(groups.empty()) << part;
        EXPECT_TRUE(std::is_sorted(groups.begin(), groups.end())) << part;
        EXPECT_EQ(std::adjacent_find(groups.begin(), groups.end()), groups.end()) << part;
    }
    EXPECT_TRUE(groupsOf(gameData().parts, "no such part").empty());
}

TEST(PartGroups, AreThoseInWhichAPlayerLooks) {
    auto const expectIn = [](PartGroup group, std::initializer_list<char const*> parts) {
        for (char const* const part : parts) {
            Groups const groups = groupsOf(gameData().parts, part);
            EXPECT_TRUE(std::count(groups.begin(), groups.end(), group) == 1)
                << part << " is not in " << partGroupNames[static_cast<std::size_t>(group)];
        }
    };
    expectIn(PartGroup::electricity, {"battery", "lamp", "bulb", "fuse", "mains", "socket", "plug", "relay",
                                      "motor", "generator", "push switch", "toggle", "pressure plate", "wire",
                                      "short wire", "electromagnet", "copper bar", "buzzer", "doorbell"});
    expectIn(PartGroup::magnets, {"bar magnet", "horseshoe magnet", "electromagnet", "compass"});
    expectIn(PartGroup::mechanics, {"seesaw", "cart", "belt", "spring", "pulley", "rope", "chain", "door",
                                    "motor", "generator", "wheel"});
    expectIn(PartGroup::water, {"water tank", "cork", "beach ball", "balloon", "raft", "float"});
    expectIn(PartGroup::sound, {"bell", "buzzer", "doorbell", "metronome", "sound sensor"});
    expectIn(PartGroup::structures, {"wall", "ramp", "shelf", "slide"});
    expectIn(PartGroup::solids, {"iron ball", "wooden ball", "steel bar", "plank", "crate", "cork"});
}

TEST(PartGroups, OfAnUnlistedPartFollowFromItsProperties) {
    std::string const plastic = R"("material": "plastic")";
    auto const single = [&](std::string const& properties) {
        return groupsOfNew(R"("properties": {)" + box(properties) + "}");
    };
    EXPECT_EQ(single(plastic), Groups{PartGroup::solids});
    EXPECT_EQ(single(plastic + R"(, "fixed": true)"), Groups{PartGroup::structures});
    EXPECT_EQ(single(plastic + R"(, "conductor": true, "electrical_device": true)"),
              Groups{PartGroup::electricity});
    EXPECT_EQ(single(plastic + R"(, "density": 30)"), (Groups{PartGroup::water, PartGroup::solids}));
    EXPECT_EQ(single(R"("material": "copper")"), (Groups{PartGroup::electricity, PartGroup::solids}));
    EXPECT_EQ(single(plastic + R"(, "liquid": {"linear_drag": 1, "quadratic_drag": 1})").at(0),
              PartGroup::water);
}

TEST(PartGroups, OfACompositeFollowFromItsPiecesAndJoints) {
    std::string const wood =
        R"({"material": "wood", "shape": [{"form": "box", "width": 0.2, "height": 0.2}]})";
    auto const pair = [&](std::string const& second, std::string const& form) {
        return groupsOfNew(R"("objects": [{"name": "a", "properties": )" + wood +
                           R"(}, {"name": "b", "at": [1, 0], )" + second + R"(}], "joints": [{"form": ")" +
                           form + R"(", "a": "a", "b": "b", "at": [0, 0]}])");
    };
    EXPECT_EQ(pair(R"("properties": )" + wood, "hinge"), Groups{PartGroup::mechanics});
    EXPECT_EQ(pair(R"("properties": )" + wood, "weld"), Groups{PartGroup::solids});
    // A piece that is made from a part has that part's properties, unless it states otherwise.
    EXPECT_EQ(pair(R"("part": "lamp")", "hinge"), Groups{PartGroup::electricity});
    EXPECT_EQ(pair(R"("part": "battery")", "hinge"), Groups{PartGroup::electricity});
    EXPECT_EQ(pair(R"("part": "lamp", "properties": {"electrical_device": false})", "hinge"),
              Groups{PartGroup::mechanics});
    EXPECT_EQ(pair(R"("part": "bell")", "weld").at(0), PartGroup::sound);
}

TEST(PartGroups, OfTheFileCountInTheirPlace) {
    std::string const lamp =
        R"("properties": {)" + box(R"("material": "glass", "electrical_device": true)") + "}";
    EXPECT_EQ(groupsOfNew(lamp + R"(, "groups": ["sound", "magnets"])"),
              (Groups{PartGroup::magnets, PartGroup::sound}));
    EXPECT_EQ(groupsOfNew(lamp + R"(, "groups": [])"), Groups{PartGroup::electricity}) << "none are stated";
}

} // namespace
} // namespace part_groups_test
} // namespace trembler
