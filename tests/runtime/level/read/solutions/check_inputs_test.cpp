// Recorded inputs of a solution: accepted inputs, and inputs that are impossible in their level.
#include "runtime/level/read/solutions/check_inputs.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

class CheckInputs : public testing::Test {
protected:
    CheckInputs() { sample::fill(registry); }

    std::vector<std::string> problemsWith(std::string const& connections, std::string const& solution) {
        return sample::problemsOf(registry, R"({"version": 1, "title": "t",
            "objects": [{"name": "a"}, {"name": "b"}, {"name": "c"}],
            "connections": [)" + connections + R"(],
            "solutions": [{"name": "s", )" + solution +
                                                "}]}");
    }
    Registry registry;
};

TEST_F(CheckInputs, RefusesACutWithoutAWire) {
    std::string const wire = R"(["a", "b"])";
    EXPECT_TRUE(problemsWith(wire, R"("inputs": [{"frame": 3, "cut": ["b", "a"]}])").empty());
    EXPECT_SAYS(sample::only(problemsWith(wire, R"("inputs": [{"frame": 3, "cut": ["a", "c"]}])")),
                "/solutions/0/inputs/0: there is no wire between 'a' and 'c'");
    EXPECT_SAYS(sample::only(problemsWith(
                    wire, R"("inputs": [{"frame": 3, "cut": ["a", "b"]}, {"frame": 4, "cut": ["b", "a"]}])")),
                "/solutions/0/inputs/1: the wire between 'b' and 'a' has been cut before");
    EXPECT_SAYS(sample::only(problemsWith(wire, R"("inputs": [{"frame": 3, "cut": ["a", "d"]}])")),
                "there is no object 'd'");
}

TEST_F(CheckInputs, AcceptsNamesOfObjectsThatAreCreatedWhileALevelRuns) {
    auto const grabbing = [&](std::string const& name) {
        return problemsWith("", R"("inputs": [{"frame": 3, "grab": ")" + name + R"(", "at": [0, 0]}])");
    };
    EXPECT_TRUE(grabbing("bullet of a 3").empty());
    EXPECT_TRUE(grabbing("bullet of a 3 (2)").empty());
    EXPECT_SAYS(sample::only(grabbing("king of hearts")), "there is no object 'king of hearts'");
}

TEST_F(CheckInputs, AcceptsWhatMayBeAPieceOfAPart) {
    auto const problems = [&](std::string const& input) {
        return sample::problemsOf(registry, R"({"version": 2, "title": "t",
            "objects": [{"name": "front bell", "part": "bell"}, {"name": "box"}],
            "toolbox": [{"part": "lamp"}],
            "solutions": [{"name": "s", "placements": [{"part": "lamp", "at": [0, 0]}],
                           "inputs": [{"frame": 1, )" +
                                                input + "}]}]}");
    };
    EXPECT_TRUE(problems(R"("remove": "front bell coil")").empty())
        << "only the part tells whether it has one";
    EXPECT_TRUE(problems(R"("remove": "lamp 1 thin wire")").empty());
    EXPECT_TRUE(problems(R"("cut": ["front bell", "front bell coil"])").empty());
    EXPECT_SAYS(sample::only(problems(R"("remove": "front bel coil")")),
                "there is no object 'front bel coil'");
    EXPECT_SAYS(sample::only(problems(R"("remove": "box coil")")), "there is no object 'box coil'");
    EXPECT_SAYS(sample::only(problems(R"("remove": "lamp 2 wire")")), "there is no object 'lamp 2 wire'");
}

TEST_F(CheckInputs, RefusesInputsAfterTheLastFrame) {
    std::string const inputs =
        R"("inputs": [{"frame": 10, "grab": "a", "at": [0, 0]}, {"frame": 11, "release": true}])";
    EXPECT_TRUE(problemsWith("", inputs).empty()) << "a solution without an end has no last frame";
    EXPECT_TRUE(problemsWith("", inputs + R"(, "frames": 11)").empty());
    EXPECT_SAYS(sample::only(problemsWith("", inputs + R"(, "frames": 10)")),
                "/solutions/0/inputs/1: is in frame 11, after the last one; expected frames from 1 to 10");
    EXPECT_EQ(problemsWith("", inputs + R"(, "frames": 9)").size(), 2U);
}

TEST_F(CheckInputs, RefusesADuplicateConnection) {
    EXPECT_TRUE(problemsWith(R"(["a", "b"], ["b", "c"], ["c", "a"])", R"("frames": 1)").empty());
    for (char const* const twice :
         {R"(["a", "b"], ["c", "b"], ["b", "a"])", R"(["a", "b"], ["c", "b"], ["a", "b"])"}) {
        EXPECT_SAYS(sample::only(problemsWith(twice, R"("frames": 1)")),
                    "/connections/2: connects 'a' and 'b', as /connections/0 does");
    }
}

} // namespace
} // namespace trembler
