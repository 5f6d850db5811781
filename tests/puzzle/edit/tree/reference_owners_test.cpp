#include "puzzle/edit/tree/reference_owners.hpp"

#include <gtest/gtest.h>

#include <set>

namespace trembler::edit {
namespace reference_owners_test {
namespace {

Json const& ownersLevel() {
    static Json const level = Json::parse(R"({
        "objects": [{"name": "door", "part": "doorbell"}, {"name": "door lamp", "part": "lamp"},
                    {"name": "stone"}, {"part": "doorbell"}, 3],
        "joints": [{"name": "door pin", "form": "hinge"}]})");
    return level;
}

TEST(ReferenceOwners, AreEntriesOrTheObjectsOfPieces) {
    ReferenceOwners const owners(ownersLevel());
    EXPECT_EQ(owners.of("door"), "door");
    EXPECT_EQ(owners.of("door coil"), "door");
    EXPECT_EQ(owners.of("door lamp"), "door lamp");
    EXPECT_EQ(owners.of("door lamp bulb"), "door lamp") << "the longest";
    EXPECT_EQ(owners.of("door holder bulb"), "door");
    EXPECT_EQ(owners.of("door pin"), "door pin") << "a joint of the level";
    EXPECT_EQ(owners.of("stone age"), "stone age") << "it is made from no part";
    EXPECT_EQ(owners.of("doorway coil"), "doorway coil");
    EXPECT_EQ(owners.of(" coil"), " coil");
    EXPECT_EQ(owners.of(""), "");
    EXPECT_EQ(ReferenceOwners(Json(3)).of("door coil"), "door coil");
}

TEST(ReferenceOwners, AreAmongNames) {
    ReferenceOwners const owners(ownersLevel());
    std::set<std::string> const names{"door", "gone"};
    EXPECT_TRUE(owners.among(names, "door"));
    EXPECT_TRUE(owners.among(names, "door coil"));
    EXPECT_TRUE(owners.among(names, "gone")) << "as it is named";
    EXPECT_FALSE(owners.among(names, "door pin"));
    EXPECT_FALSE(owners.among(names, "door lamp bulb"));
}

} // namespace
} // namespace reference_owners_test
} // namespace trembler::edit
