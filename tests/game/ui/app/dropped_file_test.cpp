// Levels and solutions are distinguished by their keys.
#include "game/ui/app/dropped_file.hpp"
#include "runtime/file/output_file.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {
namespace dropped_file_test {
namespace {

using Kind = DroppedFile::Kind;

Kind kindOf(std::string const& text) {
    auto const file = testFolder() / "dropped.json";
    writeFile(file, text);
    DroppedFile const found = lookAtDropped(file);
    EXPECT_EQ(found.why.empty(), found.kind != Kind::neither) << found.why;
    return found.kind;
}

TEST(DroppedFile, IsALevelASolutionOrNeither) {
    EXPECT_EQ(kindOf(R"({"version": 2, "title": "t", "objects": []})"), Kind::level);
    EXPECT_EQ(kindOf(R"({"name": "n", "placements": []})"), Kind::solution);
    EXPECT_EQ(kindOf(R"({"name": "n", "inputs": []})"), Kind::solution);
    EXPECT_EQ(kindOf(R"({"name": "n", "wires": [["a", "b"]]})"), Kind::solution);
    EXPECT_EQ(kindOf(R"({"name": "a part", "properties": {}})"), Kind::neither);
    EXPECT_EQ(kindOf("3"), Kind::neither);
    EXPECT_EQ(kindOf("not JSON"), Kind::neither);
    EXPECT_EQ(lookAtDropped(testFolder()).kind, Kind::neither) << "a folder";
    EXPECT_EQ(lookAtDropped(testFolder() / "none.json").kind, Kind::neither);
    for (auto const& level : {"first/1-first-contact.json", "experiments/2-doorbell.json"}) {
        EXPECT_EQ(lookAtDropped(levelsFolder() / level).kind, Kind::level);
    }
}

} // namespace
} // namespace dropped_file_test
} // namespace trembler::ui::test
