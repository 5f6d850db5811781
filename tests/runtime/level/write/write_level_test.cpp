// Every section of a level, and everything that a solution records, is read as it was written.
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"
#include "runtime/level/write/write_level.hpp"
#include "tests/runtime/level/model/bakery.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <optional>
#include <string>
#include <vector>

namespace trembler {
namespace write_level_test {
namespace {

Registry const& registry() {
    static Registry const shared = [] {
        Registry made;
        sample::fill(made);
        made.property<bakery::Oven>();
        made.component<bakery::ExactBaking>();
        made.component<bakery::RoughBaking>();
        made.extension("mill");
        made.extension("shop");
        return made;
    }();
    return shared;
}

int below(int bound) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, bound));
}
bool heads() {
    return below(2) == 0;
}
/// Names with characters that a file must escape or encode.
std::string word() {
    return *rc::gen::element<std::string>("a", "b c", "Käse", "x\"y\\z", "100 %", "{}", "~/");
}
/// Not a round number, so that every digit counts.
double number() {
    return (below(2'000'001) - 1'000'000) / 977.0;
}
Vec2 point() {
    double const x = number();
    double const y = number();
    return {x, y};
}

Solution randomSolution() {
    Solution solution;
    solution.name = word();
    solution.solves = heads();
    if (heads()) {
        solution.frames = 1 + below(10'000);
    }
    for (int i = below(4); i > 0; --i) {
        Placement placement;
        placement.part = word();
        placement.at = point();
        placement.angle = heads() ? 0 : radians((below(5761) - 2880) / 8.0);
        placement.flipped = heads();
        solution.placements.push_back(placement);
    }
    std::uint64_t frame = 1;
    for (int i = below(6); i > 0; --i) {
        RecordedInput input;
        frame += static_cast<std::uint64_t>(below(3)); // several in one frame keep their order
        input.frame = frame;
        input.kind = static_cast<PlayerInput::Kind>(below(5));
        bool const grabs = input.kind == PlayerInput::Kind::grab;
        bool const moves = input.kind == PlayerInput::Kind::move;
        bool const cuts = input.kind == PlayerInput::Kind::cut;
        if (grabs || moves) {
            input.at = point();
        }
        if (grabs || cuts || input.kind == PlayerInput::Kind::remove) {
            input.object = word();
        }
        if (cuts) {
            input.other = word();
        }
        solution.inputs.push_back(input);
    }
    frame = 1;
    for (int i = below(6); i > 0; --i) {
        RecordedChange change;
        switch (below(3)) {
        case 0:
            change = bakery::detailTo(word(), heads() ? "" : word());
            break;
        case 1:
            change = bakery::periodTo(word(), 1 + below(3600));
            break;
        default:
            change = bakery::settingTo(word(), word(), number());
            break;
        }
        frame += static_cast<std::uint64_t>(below(3));
        change.frame = frame;
        solution.changes.push_back(change);
    }
    return solution;
}

TEST(WriteSolution, IsReadAsItWasWritten) {
    EXPECT_TRUE(rc::check("random solutions", [] {
        Solution const solution = randomSolution();
        auto const document = JsonDocument::parse(writeSolution(solution).dump(), "solution.json");
        Problems problems;
        auto const again = readSolution(JsonNode(*document, document->root(), "", problems));
        problems.throwIfAny();
        RC_ASSERT(again.has_value());
        RC_ASSERT(again->name == solution.name);
        RC_ASSERT(again->solves == solution.solves);
        RC_ASSERT(again->frames == solution.frames);
        RC_ASSERT(again->placements.size() == solution.placements.size());
        for (std::size_t i = 0; i < solution.placements.size(); ++i) {
            RC_ASSERT(again->placements[i].part == solution.placements[i].part);
            RC_ASSERT(again->placements[i].at == solution.placements[i].at);
            RC_ASSERT(again->placements[i].angle == solution.placements[i].angle);
            RC_ASSERT(again->placements[i].flipped == solution.placements[i].flipped);
        }
        RC_ASSERT(again->inputs.size() == solution.inputs.size());
        for (std::size_t i = 0; i < solution.inputs.size(); ++i) {
            RC_ASSERT(again->inputs[i].frame == solution.inputs[i].frame);
            RC_ASSERT((again->inputs[i].kind == solution.inputs[i].kind));
            RC_ASSERT(again->inputs[i].object == solution.inputs[i].object);
            RC_ASSERT(again->inputs[i].other == solution.inputs[i].other);
            RC_ASSERT(again->inputs[i].at == solution.inputs[i].at);
        }
        RC_ASSERT(again->changes.size() == solution.changes.size());
        for (std::size_t i = 0; i < solution.changes.size(); ++i) {
            RC_ASSERT(again->changes[i].frame == solution.changes[i].frame);
            RC_ASSERT((again->changes[i].kind == solution.changes[i].kind));
            RC_ASSERT(again->changes[i].subject == solution.changes[i].subject);
            RC_ASSERT(again->changes[i].field == solution.changes[i].field);
            RC_ASSERT(again->changes[i].level == solution.changes[i].level);
            RC_ASSERT(again->changes[i].value == solution.changes[i].value);
        }
    }));
}

Area randomArea() {
    Vec2 const corner = point();
    double const width = (1 + below(1000)) / 8.0;
    double const height = (1 + below(1000)) / 8.0;
    Area area;
    if (heads()) {
        area.box = Box{corner, {width, height}};
    } else {
        area.corners = {corner, corner + Vec2{width, 0}, corner + Vec2{0, height}};
    }
    return area;
}

LevelFile randomLevel() {
    LevelFile level;
    level.title = word();
    level.text = heads() ? "" : word() + "\n" + word();
    level.demonstration = heads();
    for (char const* const name : {"shop", "mill"}) {
        if (heads()) {
            level.mods.emplace_back(name);
        }
    }
    if (heads()) {
        level.bounds = Box{point(), {(1 + below(1000)) / 8.0, (1 + below(1000)) / 8.0}};
    }
    if (heads()) {
        level.detail["baking"] = heads() ? "exact" : "rough";
    }
    if (heads()) {
        level.world.set(sample::Climate{{below(101) / 2.0 - 25, below(101) / 2.0 - 25}});
    }
    for (char const* const name : {"a", "b", "Käse", "x\"y"}) {
        LevelObject object;
        object.name = name;
        object.part = heads() ? "" : word();
        if (heads()) {
            object.properties.set(sample::Weight{(1 + below(1000)) / 16.0});
        }
        object.flipped = heads();
        if (heads()) {
            object.pieces[word()].set(sample::Weight{(1 + below(1000)) / 16.0});
        }
        level.objects.push_back(object);
    }
    if (heads()) {
        level.connections.push_back({"a", "Käse", ""});
    }
    if (heads()) {
        level.connections.push_back({"x\"y", "b", "", "string"});
    }
    if (heads()) {
        level.placing.emplace(); // without areas: parts may be placed nowhere
        for (int i = below(3); i > 0; --i) {
            level.placing->push_back(randomArea());
        }
    }
    if (heads()) {
        level.toolbox.push_back({"part of the level", 1 + below(1000), ""});
    }
    if (heads()) {
        level.toolbox.push_back({"x\"y", 1, ""});
    }
    if (heads()) {
        level.goals = nlohmann::json::parse(R"({"inside": {"object": "a", "numbers": [1, 2.5, -3]}})");
    }
    for (int i = below(3); i > 0; --i) {
        level.hints.push_back(word());
    }
    return level;
}

TEST(WriteLevel, IsReadAsItWasWrittenSectionBySection) {
    EXPECT_TRUE(rc::check("random levels", [] {
        LevelFile const level = randomLevel();
        LevelFile const again = readLevel(registry(), JsonDocument::parse(levelText(level), "written.json"));
        RC_ASSERT(again.title == level.title);
        RC_ASSERT(again.text == level.text);
        RC_ASSERT(again.demonstration == level.demonstration);
        RC_ASSERT(again.mods == level.mods);
        RC_ASSERT((again.bounds == level.bounds));
        RC_ASSERT(again.detail == level.detail);
        sample::Climate const* const climate = level.world.find<sample::Climate>();
        sample::Climate const* const read = again.world.find<sample::Climate>();
        RC_ASSERT((climate == nullptr) == (read == nullptr));
        RC_ASSERT(
            (climate == nullptr || read->wind == climate->wind)); // parentheses keep || from being overloaded
        RC_ASSERT(again.objects.size() == level.objects.size());
        for (std::size_t i = 0; i < level.objects.size(); ++i) {
            RC_ASSERT(again.objects[i].name == level.objects[i].name);
            RC_ASSERT(again.objects[i].part == level.objects[i].part);
            sample::Weight const* const stated = level.objects[i].properties.find<sample::Weight>();
            sample::Weight const* const found = again.objects[i].properties.find<sample::Weight>();
            RC_ASSERT((stated == nullptr) == (found == nullptr));
            RC_ASSERT((stated == nullptr || found->value == stated->value));
            RC_ASSERT(again.objects[i].flipped == level.objects[i].flipped);
            RC_ASSERT(again.objects[i].pieces.size() == level.objects[i].pieces.size());
            for (auto const& [piece, properties] : level.objects[i].pieces) {
                sample::Weight const* const weight = again.objects[i].pieces.at(piece).find<sample::Weight>();
                RC_ASSERT(weight != nullptr);
                RC_ASSERT(weight->value == properties.find<sample::Weight>()->value);
            }
        }
        RC_ASSERT(again.connections.size() == level.connections.size());
        for (std::size_t i = 0; i < level.connections.size(); ++i) {
            RC_ASSERT(again.connections[i].a == level.connections[i].a);
            RC_ASSERT(again.connections[i].b == level.connections[i].b);
            RC_ASSERT(again.connections[i].kind == level.connections[i].kind);
        }
        RC_ASSERT((again.placing == level.placing));
        RC_ASSERT(again.toolbox.size() == level.toolbox.size());
        for (std::size_t i = 0; i < level.toolbox.size(); ++i) {
            RC_ASSERT(again.toolbox[i].part == level.toolbox[i].part);
            RC_ASSERT(again.toolbox[i].count == level.toolbox[i].count);
        }
        RC_ASSERT((again.goals == level.goals));
        RC_ASSERT(again.hints == level.hints);
    }));
}

TEST(WriteLevel, LeavesOutWhatHasItsInitialValue) {
    LevelFile level;
    level.title = "empty";
    EXPECT_EQ(writeLevel(level).dump(), R"({"version":2,"title":"empty"})");
    Solution solution;
    solution.name = "nothing";
    EXPECT_EQ(writeSolution(solution).dump(), R"({"name":"nothing"})");
}

} // namespace
} // namespace write_level_test
} // namespace trembler
