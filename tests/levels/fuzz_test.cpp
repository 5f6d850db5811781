// For any damage to a level file, the program reports the error and its place, or plays the level.
#include "puzzle/goals/goal_judge.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "tests/levels/level_kit.hpp"
#include "tests/levels/schema_validator.hpp"
#include "tests/support/attempts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>

namespace trembler {
namespace {

using Json = nlohmann::json;
using Random = std::mt19937;

std::size_t below(Random& random, std::size_t count) {
    return random() % count;
}

/// All places in a document.
void collect(Json& value, std::vector<Json*>& all) {
    all.push_back(&value);
    if (value.is_structured()) {
        for (Json& inner : value) {
            collect(inner, all);
        }
    }
}

Json anything(Random& random) {
    static std::vector<Json> const values{
        nullptr,
        true,
        false,
        0,
        -1,
        1,
        3,
        1e-320,
        5e-324,
        -0.0,
        1e300,
        -1e300,
        1e6,
        -1e6,
        1e9,
        1e-9,
        0.004999,
        0.01,
        2147483647,
        2147483648.0,
        -2147483649.0,
        1e18,
        9007199254740993,
        18446744073709551615U,
        "",
        "crate",
        "lamp",
        "world",
        "it",
        "steel bar 1",
        "hinge",
        "gear",
        "weld",
        "pulley",
        "wheel",
        "slider",
        "distance",
        "polygon",
        "circle",
        "capsule",
        "both",
        Json::array(),
        Json::object(),
        Json::array({0, 0}),
        Json::array({1e6, -1e6}),
        Json::array({0, 0, 0, 0}),
        Json::array({Json::array({0, 0}), Json::array({1, 0}), Json::array({2, 0})}),
        Json::array({Json::array({0, 0}), Json::array({0, 1}), Json::array({1, 0})}),
        std::string(200, 'x'),
        std::string("a\0b", 3),
        "\xc3\xa4"};
    return values[below(random, values.size())];
}

/// Keys that are valid somewhere, to add members at invalid places.
std::string anyKey(Random& random) {
    static std::vector<std::string> const keys{"name",
                                               "part",
                                               "at",
                                               "angle_deg",
                                               "properties",
                                               "shape",
                                               "form",
                                               "corners",
                                               "width",
                                               "radius",
                                               "mass",
                                               "density",
                                               "fixed",
                                               "a",
                                               "b",
                                               "joint_a",
                                               "joint_b",
                                               "length",
                                               "ratio",
                                               "axis",
                                               "motor",
                                               "limited",
                                               "lower_deg",
                                               "upper_deg",
                                               "lower",
                                               "upper",
                                               "friction",
                                               "restitution",
                                               "magnetic_poles",
                                               "magnetic_strength",
                                               "conductor",
                                               "electrical_source",
                                               "gravity",
                                               "gravity_law",
                                               "detail",
                                               "goals",
                                               "for",
                                               "not",
                                               "count",
                                               "of",
                                               "that",
                                               "electromagnet",
                                               "velocity",
                                               "bullet",
                                               "collision",
                                               "ground_a",
                                               "break_force",
                                               "stiffness",
                                               "xyzzy"};
    return keys[below(random, keys.size())];
}

void changeTree(Json& document, Random& random) {
    std::vector<Json*> all;
    collect(document, all);
    Json& victim = *all[below(random, all.size())];
    switch (below(random, 6)) {
    case 0:
        victim = anything(random);
        break;
    case 1: // another value of the same document
        victim = Json(*all[below(random, all.size())]);
        break;
    case 2:
        if (victim.is_structured() && !victim.empty()) {
            auto at = victim.begin();
            std::advance(at, static_cast<std::ptrdiff_t>(below(random, victim.size())));
            victim.erase(at);
        }
        break;
    case 3:
        if (victim.is_array()) {
            victim.push_back(victim.empty() ? anything(random) : victim[below(random, victim.size())]);
        }
        break;
    case 4:
        if (victim.is_object()) {
            victim[anyKey(random)] =
                below(random, 2) == 0 ? anything(random) : Json(*all[below(random, all.size())]);
        }
        break;
    default:
        if (victim.is_number()) {
            double const factor = std::array{-1.0, 0.0, 1e-3, 1e3, 1e-9, 1e9}[below(random, 6)];
            victim = victim.get<double>() * factor;
        }
    }
}

void changeBytes(std::string& text, Random& random) {
    std::size_t const at = below(random, text.size());
    switch (below(random, 4)) {
    case 0:
        text[at] = static_cast<char>(random() % 256);
        break;
    case 1:
        text.erase(at, 1 + below(random, 20));
        break;
    case 2:
        text.insert(at, 1, "{}[],:\"0-e.\\ntf"[below(random, 15)]);
        break;
    default:
        text.resize(at);
    }
    if (text.empty()) {
        text = " ";
    }
}

struct Outcome {
    bool played = false;
    std::string problem;
};

/// Reads, builds, judges and runs; any exception other than InputError fails the test.
Outcome tryOut(std::string const& text) {
    try {
        LevelFile const level = readLevel(levelKit().registry, JsonDocument::parse(text, "fuzz.json"));
        std::vector<Placement> placements;
        if (!level.solutions.empty()) {
            placements = level.solutions[0].placements;
        }
        auto const world = buildWorld(levelKit().registry, level, levelKit().parts, placements);
        GoalJudge judge(level, *world);
        for (int frame = 0; frame < 3; ++frame) {
            world->step();
            judge.update(*world);
        }
        return {true, ""};
    } catch (InputError const& error) {
        for (Diagnostic const& diagnostic : error.diagnostics()) {
            EXPECT_FALSE(diagnostic.message.empty());
            bool const summary = diagnostic.message.starts_with("and ");
            EXPECT_TRUE(diagnostic.line > 0 || summary) << diagnostic.print() << "\n" << text;
            EXPECT_NO_THROW((void)Json(diagnostic.print()).dump()) << "not UTF-8";
        }
        return {false, error.what()};
    }
}

unsigned tries(unsigned usual) {
    return test::attempts(usual, 100);
}

TEST(LevelFuzzSample, Plays) {
    EXPECT_EQ(tryOut(sampleLevel()).problem, "");
}

/// Every tenth seed, so that no single test takes long, even under a sanitizer.
class LevelFuzz : public testing::TestWithParam<unsigned> {};
constexpr unsigned parts = 10;

TEST_P(LevelFuzz, ChangedValuesPlayOrAreRefusedWithAPlace) {
    unsigned played = 0;
    unsigned tried = 0;
    Json const schema = levelSchema(levelKit().registry);
    for (unsigned seed = GetParam(); seed < tries(4000); seed += parts) {
        Random random(seed);
        Json document = Json::parse(sampleLevel());
        for (std::size_t changes = 1 + below(random, 3); changes > 0; --changes) {
            changeTree(document, random);
        }
        SCOPED_TRACE(seed);
        ++tried;
        if (tryOut(document.dump(1)).played) {
            ++played;
            if (document["version"] ==
                levelVersion) { // the schema must accept every level that the program plays
                EXPECT_EQ(validate(schema, document), std::vector<std::string>());
            }
        }
    }
    // Both outcomes must be frequent, or this tests nothing.
    EXPECT_GT(played, tried / 20);
    EXPECT_LT(played, tried - tried / 20);
}

TEST_P(LevelFuzz, ChangedBytesPlayOrAreRefusedWithAPlace) {
    for (unsigned seed = GetParam(); seed < tries(2000); seed += parts) {
        Random random(seed);
        std::string text = sampleLevel();
        for (std::size_t changes = 1 + below(random, 3); changes > 0; --changes) {
            changeBytes(text, random);
        }
        SCOPED_TRACE(seed);
        (void)tryOut(text);
    }
}

INSTANTIATE_TEST_SUITE_P(Part, LevelFuzz, testing::Range(0U, parts));

} // namespace
} // namespace trembler
