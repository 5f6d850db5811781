// New names of placed objects: of the objects, of their pieces, and back.
#include "puzzle/session/renaming.hpp"
#include "runtime/level/build/placing.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace renaming_test {
namespace {

TEST(Renaming, FollowsObjectsAndTheirPiecesAndNotTheLevelsOwn) {
    Renaming renaming({"cork 20", "scale 3 pan"});
    renaming.add("cork 1", "");
    renaming.add("cork 2", "cork 1");
    renaming.add("scale 3", "scale 2");
    renaming.add("bar 1", "bar 1");
    EXPECT_EQ(renaming.newName("cork 1"), "") << "it is gone";
    EXPECT_EQ(renaming.newName("cork 1 string"), "");
    EXPECT_EQ(renaming.newName("cork 2"), "cork 1");
    EXPECT_EQ(renaming.newName("scale 3 beam"), "scale 2 beam");
    EXPECT_FALSE(renaming.newName("scale 3 pan"));
    EXPECT_FALSE(renaming.newName("cork 20"));
    EXPECT_FALSE(renaming.newName("cork 21")) << "another number, not a piece of cork 2";
    EXPECT_FALSE(renaming.newName("bar 1"));
    EXPECT_EQ(renaming.oldName("cork 1"), "cork 2");
    EXPECT_EQ(renaming.oldName("scale 2 beam"), "scale 3 beam");
    EXPECT_FALSE(renaming.oldName("cork 20"));
    EXPECT_FALSE(renaming.empty());
    EXPECT_TRUE(Renaming().empty());
}

TEST(Renaming, NamesAreReturnedInTheOrderOfThePlacements) {
    std::vector<Placement> placements(3);
    placements[0] = {"cork", {3, 0}, 0, ""};
    placements[1] = {"bar", {2, 0}, 0, ""};
    placements[2] = {"cork", {1, 0}, 0, ""};
    std::vector<std::string> const names =
        namesAsStated(placements, placementNames(std::set<std::string>{}, placements));
    EXPECT_EQ(names, (std::vector<std::string>{"cork 2", "bar 1", "cork 1"}));
}

} // namespace
} // namespace renaming_test
} // namespace trembler::test
