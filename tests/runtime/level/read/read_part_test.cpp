// The groups that a part's file states.
#include "runtime/level/read/read_part.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace read_part_test {
namespace {

class ReadPart : public testing::Test {
protected:
    ReadPart() { sample::fill(registry); }

    [[nodiscard]] PartDefinition read(std::string const& members) const {
        return readPart(registry, JsonDocument::parse(R"({"name": "p")" + members + "}", "p.json"));
    }
    [[nodiscard]] std::string problem(std::string const& members) const {
        try {
            (void)read(members);
            return "";
        } catch (InputError const& error) {
            return error.what();
        }
    }
    Registry registry;
};

TEST_F(ReadPart, HasTheGroupsThatItsFileStates) {
    EXPECT_FALSE(read("").groups);
    auto const stated = read(R"(, "groups": ["water", "electricity"])").groups;
    ASSERT_TRUE(stated);
    EXPECT_EQ(*stated, (std::vector<PartGroup>{PartGroup::water, PartGroup::electricity}));
    for (std::size_t i = 0; i < partGroupNames.size(); ++i) {
        auto const one = read(R"(, "groups": [")" + std::string(partGroupNames[i]) + "\"]").groups;
        ASSERT_TRUE(one);
        EXPECT_EQ(*one, std::vector<PartGroup>{static_cast<PartGroup>(i)});
    }
}

TEST_F(ReadPart, WrongGroupsAreReported) {
    EXPECT_NE(problem(R"(, "groups": ["elektricity"])").find("electricity"), std::string::npos);
    EXPECT_NE(problem(R"(, "groups": ["water", "water"])").find("every group once"), std::string::npos);
    EXPECT_NE(problem(R"(, "groups": "water")").find("a list of groups"), std::string::npos);
    EXPECT_NE(problem(R"(, "groups": [7])"), "");
    EXPECT_NE(problem(R"(, "group": ["water"])").find("groups"), std::string::npos) << "a similar key";
}

} // namespace
} // namespace read_part_test
} // namespace trembler
