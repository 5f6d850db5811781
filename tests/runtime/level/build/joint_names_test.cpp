// Joints without names get unique numbers that do not depend on the order of the file.
#include "runtime/level/build/joint_names.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <set>

namespace trembler {
namespace joint_names_test {
namespace {

struct Tie {
    std::string name; // "": none
    int strength = 0;
};

LevelFile levelOf(Registry const& registry, std::vector<std::string> const& objects,
                  std::vector<Tie> const& ties) {
    std::string text = R"({"version": 2, "title": "t", "objects": [)";
    for (std::string const& object : objects) {
        text += R"({"name": ")" + object + R"("}, )";
    }
    text += R"({"name": "end"}], "joints": [)";
    for (std::size_t i = 0; i < ties.size(); ++i) {
        text += i == 0 ? "" : ", ";
        text += ties[i].name.empty() ? "{" : R"({"name": ")" + ties[i].name + R"(", )";
        text += R"("a": "end", "strength": )" + std::to_string(ties[i].strength) + "}";
    }
    return sample::read(registry, text + "]}");
}

class JointNames : public testing::Test {
protected:
    JointNames() { sample::fill(registry); }
    Registry registry;
};

TEST_F(JointNames, KeepStatedNamesAndNumberTheOthers) {
    EXPECT_EQ(jointNames(levelOf(registry, {}, {{"", 2}, {"axle", 5}, {"", 3}})),
              (std::vector<std::string>{"joint 1", "axle", "joint 2"}));
    EXPECT_EQ(jointNames(levelOf(registry, {"joint 1"}, {{"", 3}, {"joint 3", 5}, {"", 2}})),
              (std::vector<std::string>{"joint 4", "joint 3", "joint 2"}))
        << "an object and a joint already have such names; the weaker joint comes first";
    EXPECT_TRUE(jointNames(levelOf(registry, {}, {})).empty());
}

TEST_F(JointNames, AreUniqueAndTheSameForAnyOrderOfTheFile) {
    EXPECT_TRUE(rc::check([&] {
        std::vector<std::string> objects;
        std::vector<Tie> ties;
        for (int i = 1; i <= 4; ++i) { // each such name belongs to an object, to a joint or is free
            int const whose = *rc::gen::inRange(0, 3);
            if (whose == 0) {
                objects.push_back("joint " + std::to_string(i));
            } else if (whose == 1) {
                ties.push_back({"joint " + std::to_string(i), *rc::gen::inRange(1, 5)});
            }
        }
        int const nameless = *rc::gen::inRange(0, 6);
        for (int i = 0; i < nameless; ++i) {
            ties.push_back({"", *rc::gen::inRange(1, 5)});
        }
        auto const strengths = [&](std::vector<Tie> const& in) {
            std::vector<std::string> const names = jointNames(levelOf(registry, objects, in));
            RC_ASSERT(names.size() == in.size());
            std::map<std::string, int> found;
            for (std::size_t i = 0; i < names.size(); ++i) {
                RC_ASSERT(in[i].name.empty() || names[i] == in[i].name);
                RC_ASSERT(std::find(objects.begin(), objects.end(), names[i]) == objects.end());
                RC_ASSERT(found.emplace(names[i], in[i].strength).second);
            }
            return found;
        };
        std::map<std::string, int> const expected = strengths(ties);
        auto const first = static_cast<std::ptrdiff_t>(
            ties.empty() ? 0 : *rc::gen::inRange(0, static_cast<int>(ties.size())));
        std::rotate(ties.begin(), ties.begin() + first, ties.end());
        RC_ASSERT(strengths(ties) == expected);
        std::reverse(ties.begin(), ties.end());
        RC_ASSERT(strengths(ties) == expected);
    }));
}

} // namespace
} // namespace joint_names_test
} // namespace trembler
