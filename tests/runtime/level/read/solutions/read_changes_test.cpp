// Changes that were recorded with a solution are written and read.
#include "runtime/level/model/world_change.hpp"
#include "runtime/level/read/solutions/read_changes.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"
#include "runtime/level/write/write_level.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace trembler {
namespace read_changes_test {
namespace {

std::optional<Solution> read(std::string const& text, std::vector<std::string>* wrong = nullptr) {
    auto const document = JsonDocument::parse(text, "solution.json");
    Problems problems;
    auto solution = readSolution(JsonNode(*document, document->root(), "", problems));
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            if (wrong != nullptr) {
                wrong->push_back(diagnostic.print());
            }
        }
        return std::nullopt;
    }
    return solution;
}

TEST(Changes, AreWrittenAsTheyAreRead) {
    auto const first = read(R"({"name": "n", "changes": [
        {"frame": 90, "detail": {"gravity": "tree", "electricity": ""}},
        {"frame": 61, "period": {"Buoyancy Resolver": 4}},
        {"frame": 61, "setting": {"gravity_law": {"opening_angle": 0.5}, "solver": {"substeps": 2}}}]})");
    ASSERT_TRUE(first);
    ASSERT_EQ(first->changes.size(), 5U);
    EXPECT_EQ(first->changes[0].frame, 61U) << "in order of time";
    EXPECT_EQ(inWords(first->changes[0]), "Buoyancy Resolver: every 4 frames");
    EXPECT_EQ(inWords(first->changes[1]), "gravity_law: opening_angle 0.5");
    EXPECT_EQ(inWords(first->changes[4]), "gravity: tree");
    auto const again = read(writeSolution(*first).dump());
    ASSERT_TRUE(again);
    ASSERT_EQ(again->changes.size(), first->changes.size());
    for (std::size_t i = 0; i < first->changes.size(); ++i) {
        EXPECT_EQ(again->changes[i].frame, first->changes[i].frame);
        EXPECT_EQ(inWords(again->changes[i]), inWords(first->changes[i]));
    }
    EXPECT_TRUE(read(R"({"name": "old"})")->changes.empty());
    EXPECT_FALSE(writeSolution(*read(R"({"name": "old"})")).contains("changes"));
}

TEST(Changes, AreReportedWithTheirErrors) {
    struct Case {
        char const* entry;
        char const* says;
    };
    for (Case const& c :
         {Case{R"({"frame": 0, "detail": {"gravity": "tree"}})", "/changes/0/frame"},
          Case{R"({"detail": {"gravity": "tree"}})", "frame"}, Case{R"({"frame": 1})", "states no change"},
          Case{R"({"frame": 1, "detail": {"a": "b"}, "period": {"c": 2}})", "several kinds"},
          Case{R"({"frame": 1, "detail": {}})", "changes nothing"},
          Case{R"({"frame": 1, "detail": {"gravity": 3}})", "/changes/0/detail/gravity"},
          Case{R"({"frame": 1, "period": {"Buoyancy": 0}})", "/changes/0/period/Buoyancy"},
          Case{R"({"frame": 1, "period": {"Buoyancy": 1.5}})", "/changes/0/period/Buoyancy"},
          Case{R"({"frame": 1, "setting": {"solver": 3}})", "/changes/0/setting/solver"},
          Case{R"({"frame": 1, "setting": {"solver": {"substeps": "x"}}})", "substeps"},
          Case{R"({"frame": 1, "detial": {"gravity": "tree"}})", "detial"}, Case{R"(7)", "/changes/0"}}) {
        std::vector<std::string> wrong;
        EXPECT_FALSE(read(std::string(R"({"name": "n", "changes": [)") + c.entry + "]}", &wrong)) << c.entry;
        std::string all;
        for (std::string const& line : wrong) {
            all += line + "\n";
        }
        EXPECT_NE(all.find(c.says), std::string::npos) << c.entry << " says: " << all;
    }
}

} // namespace
} // namespace read_changes_test
} // namespace trembler
