// The section "world" of a level file: properties of the world, bounds and detail levels.
#include "runtime/level/read/read_world.hpp"
#include "tests/runtime/level/model/bakery.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <string>
#include <vector>

namespace trembler {
namespace read_world_test {
namespace {

using bakery::Oven;
using sample::Climate;

Registry const& registry() {
    static Registry const shared = [] {
        Registry made;
        sample::fill(made);
        made.property<Oven>();
        made.component<bakery::ExactBaking>();
        made.component<bakery::RoughBaking>();
        made.component<bakery::Timer>();
        return made;
    }();
    return shared;
}

struct Reading {
    LevelFile level;
    std::vector<std::string> said;
};

Reading readingOf(std::string const& text) {
    auto const document = JsonDocument::parse(text, "f.json");
    Problems problems;
    Reading made;
    readWorld(registry(), JsonNode(*document, document->root(), "", problems), made.level);
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        for (Diagnostic const& one : error.diagnostics()) {
            made.said.push_back(one.print());
        }
    }
    return made;
}

TEST(ReadWorld, ReadsWhatIsStated) {
    Reading const read = readingOf(R"({"climate": [3, -1], "oven": {"layers": 4, "heat": 180.5},
        "bounds": [-1, -2, 3, 4], "detail": {"baking": "rough"}})");
    EXPECT_TRUE(read.said.empty()) << read.said.front();
    ASSERT_NE(read.level.world.find<Climate>(), nullptr);
    EXPECT_EQ(read.level.world.find<Climate>()->wind, (Vec2{3, -1}));
    Oven const* const oven = read.level.world.find<Oven>();
    ASSERT_NE(oven, nullptr);
    EXPECT_EQ(oven->layers, 4);
    EXPECT_EQ(oven->heat, 180.5);
    EXPECT_EQ(oven->tolerance, 0.5) << "the default";
    ASSERT_TRUE(read.level.bounds);
    EXPECT_EQ(*read.level.bounds, (Box{{-1, -2}, {3, 4}}));
    EXPECT_EQ(read.level.detail, (std::map<std::string, std::string>{{"baking", "rough"}}));
}

TEST(ReadWorld, ReadsNothingElse) {
    EXPECT_TRUE(rc::check("any members, in any order", [] {
        struct Member {
            char const* text;
            bool (*read)(LevelFile const&);
        };
        static Member const members[] = {
            {R"("climate": [1, 2])", [](LevelFile const& l) { return l.world.find<Climate>() != nullptr; }},
            {R"("oven": {})", [](LevelFile const& l) { return l.world.find<Oven>() != nullptr; }},
            {R"("bounds": [0, 0, 1, 1])", [](LevelFile const& l) { return l.bounds.has_value(); }},
            {R"("detail": {"baking": "exact"})", [](LevelFile const& l) { return !l.detail.empty(); }}};
        std::string text;
        std::vector<bool> stated(4, false);
        for (int i = 0; i < 4; ++i) {
            auto const which = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, 4));
            if (!stated[which]) {
                stated[which] = true;
                text += (text.empty() ? "" : ", ") + std::string(members[which].text);
            }
            if (*rc::gen::arbitrary<bool>()) {
                break;
            }
        }
        Reading const read = readingOf("{" + text + "}");
        RC_ASSERT(read.said.empty());
        for (std::size_t i = 0; i < 4; ++i) {
            RC_ASSERT(members[i].read(read.level) == stated[i]);
        }
    }));
    Reading const none = readingOf("{}");
    EXPECT_TRUE(none.said.empty());
    EXPECT_TRUE(none.level.world.empty());
    EXPECT_FALSE(none.level.bounds);
    EXPECT_TRUE(none.level.detail.empty());
}

TEST(ReadWorld, SaysWhatIsWrongAndWhere) {
    struct Case {
        char const* text;
        std::vector<std::string> says;
    };
    for (Case const& c : std::vector<Case>{
             {"3", {"an object"}},
             {"[]", {"an object"}},
             {"null", {"an object"}},
             {R"({"ovn": {}})",
              {"/ovn:", "'ovn'", "did you mean 'oven'?", "'bounds'", "'detail'", "'climate'"}},
             {R"({"bound": [0, 0, 1, 1]})", {"/bound:", "did you mean 'bounds'?"}},
             {R"({"weight": 2})", {"/weight:", "'weight'"}}, // objects have it, the world has not
             {R"({"oven": {"layers": 65}})", {"/oven/layers:", "65"}},
             {R"({"climate": [3, "x"]})", {"/climate/1:"}},
             {R"({"bounds": [0, 0, 0, 1]})", {"/bounds/2:"}},
             {R"({"detail": "rough"})", {"/detail:", "{effect: detail level}"}},
             {R"({"detail": {"bakin": "rough"}})", {"/detail/bakin:", "did you mean 'baking'?"}},
             {R"({"detail": {"timer": "rough"}})", {"/detail/timer:", "'baking'"}}, // has one level only
             {R"({"detail": {"baking": "roug"}})", {"/detail/baking:", "exact", "rough"}},
             {R"({"detail": {"baking": 1}})", {"/detail/baking:"}}}) {
        Reading const read = readingOf(c.text);
        ASSERT_EQ(read.said.size(), 1U) << c.text;
        for (std::string const& part : c.says) {
            EXPECT_NE(read.said[0].find(part), std::string::npos) << read.said[0] << " lacks " << part;
        }
        EXPECT_FALSE(read.level.bounds) << c.text;
        EXPECT_TRUE(read.level.detail.empty()) << c.text;
    }
}

TEST(ReadWorld, ReadsOnAfterAProblem) {
    Reading const read = readingOf(R"({"ovn": 1, "bounds": 3, "climate": [1, 2],
        "detail": {"frying": "deep", "baking": "exact"}})");
    EXPECT_EQ(read.said.size(), 3U);
    ASSERT_NE(read.level.world.find<Climate>(), nullptr);
    EXPECT_EQ(read.level.world.find<Climate>()->wind, (Vec2{1, 2}));
    EXPECT_EQ(read.level.detail, (std::map<std::string, std::string>{{"baking", "exact"}}));
}

} // namespace
} // namespace read_world_test
} // namespace trembler
