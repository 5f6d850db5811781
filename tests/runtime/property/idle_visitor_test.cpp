#include "runtime/property/idle_visitor.hpp"
#include "tests/runtime/property/sample_properties.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace trembler {
namespace {

using sample::Everything;

Everything filled() {
    return {.flag = true,
            .count = 3,
            .ratio = 0.25,
            .point = {1, 2},
            .label = "bell",
            .other = {4, 5},
            .mood = sample::Mood::calm,
            .numbers = {1, 2},
            .words = {"a"},
            .parts = {{.size = 2}}};
}

TEST(IdleVisitor, LeavesEveryFieldAsItIs) {
    Everything visited = filled();
    IdleVisitor idle;
    visitFields(visited, idle);
    auto const all = [](Everything const& e) {
        return std::tuple(e.flag, e.count, e.ratio, e.point, e.label, e.other, e.mood, e.numbers, e.words,
                          e.parts.size(), e.parts.at(0).size, e.parts.at(0).mood);
    };
    EXPECT_EQ(all(visited), all(filled()));
}

TEST(IdleVisitor, CallsOverriddenFunctions) {
    struct Doubler final : IdleVisitor {
        void number(FieldInfo const&, double& value) override { value *= 2; }
    } doubler;
    Everything visited = filled();
    visitFields(visited, doubler);
    EXPECT_EQ(visited.ratio, 0.5);
    EXPECT_EQ(visited.numbers, filled().numbers) << "it does not look into lists";
    EXPECT_EQ(visited.count, 3);
}

} // namespace
} // namespace trembler
