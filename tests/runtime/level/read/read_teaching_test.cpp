// The section "teaching" of a level file.
#include "runtime/level/read/read_teaching.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace trembler {
namespace read_teaching_test {
namespace {

struct Taught {
    std::vector<TeachingStep> steps;
    std::vector<std::string> said;
};

Taught taughtBy(std::string const& text) {
    auto const document = JsonDocument::parse(text, "f.json");
    Problems problems;
    Taught made;
    made.steps = readTeaching(JsonNode(*document, document->root(), "", problems));
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        for (Diagnostic const& one : error.diagnostics()) {
            made.said.push_back(one.print());
        }
    }
    return made;
}

TEST(ReadTeaching, ReadsEveryKindOfStepAndWritesItBack) {
    std::string const text = R"([{"place":"bar","at":[1.5,-2.0],"angle_deg":90.0,"flipped":true},)"
                             R"({"wire":["plus","lamp"]},{"run":true},{"grab":"ball","to":[0.0,3.0]},)"
                             R"({"cut":["plus","lamp"]}])";
    Taught const read = taughtBy(text);
    ASSERT_TRUE(read.said.empty()) << read.said.front();
    ASSERT_EQ(read.steps.size(), 5U);
    EXPECT_EQ(read.steps[0].object, "bar");
    EXPECT_EQ(read.steps[0].at, (Vec2{1.5, -2}));
    EXPECT_TRUE(read.steps[0].flipped);
    EXPECT_EQ(read.steps[1].other, "lamp");
    EXPECT_EQ(read.steps[2].kind, TeachingStep::Kind::run);
    EXPECT_EQ(read.steps[3].at, (Vec2{0, 3}));
    EXPECT_EQ(read.steps[4].kind, TeachingStep::Kind::cut);
    EXPECT_EQ(writeTeaching(read.steps).dump(), text);
}

TEST(ReadTeaching, RefusesWhatIsNoStep) {
    for (char const* text :
         {R"([{}])", R"([{"run": true, "place": "bar", "at": [0, 0]}])", R"([{"run": false}])",
          R"([{"place": "bar"}])", R"([{"wire": ["one"]}])", R"([{"grab": "ball"}])",
          R"([{"run": true, "at": [0, 0]}])", R"({"run": true})", R"([5])"}) {
        Taught const read = taughtBy(text);
        EXPECT_FALSE(read.said.empty()) << text;
        EXPECT_TRUE(read.steps.empty() || !read.said.empty()) << text;
    }
}

} // namespace
} // namespace read_teaching_test
} // namespace trembler
