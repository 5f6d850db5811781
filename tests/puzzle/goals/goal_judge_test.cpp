#include "tests/puzzle/goals/stage.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler {
namespace goal_judge_test {
namespace {

using Json = nlohmann::json;

TEST(GoalJudge, ReadsPlacesContactsAndCurrents) {
    GoalStage stage(R"({"all": [
        {"inside": {"object": "crate", "area": [0, 0, 1, 1]}},
        {"inside": {"object": "crate", "area": [[0, 0], [2, 0], [0, 2]]}},
        {"touching": ["crate", "floor"]},
        {"on": "lamp"},
        {"off": "lamp 2"},
        {"moved": {"object": "metal object", "by": 2, "towards": "up"}}]})");
    stage.step();
    EXPECT_EQ(stage.met(), "000010");
    stage.put("crate", {0.5, 0.5});
    stage.turn("lamp", true);
    stage.put("metal object", {9, 1});
    stage.step();
    EXPECT_EQ(stage.met(), "110110");
    EXPECT_DOUBLE_EQ(stage.judge().status()[5].progress, 0.5);
    stage.touch("crate", "floor");
    stage.turn("lamp 2", true);
    stage.put("metal object", {-9, 2});
    stage.step();
    EXPECT_EQ(stage.met(), "111101");
    EXPECT_FALSE(stage.judge().solved());
    stage.turn("lamp 2", false);
    stage.step();
    EXPECT_TRUE(stage.judge().solved());
    EXPECT_EQ(stage.judge().solvedFrame(), 4U);
    EXPECT_EQ(stage.judge().status()[0].frame, 2U);
    EXPECT_EQ(stage.judge().status()[4].frame, 1U);
    stage.turn("lamp", false);
    stage.step(); // a solved goal stays solved
    EXPECT_EQ(stage.met(), "111111");
}

TEST(GoalJudge, RequiresDurationsWithoutABreak) {
    GoalStage stage(R"({"on": "lamp", "for": 0.5})");
    stage.turn("lamp", true);
    stage.step(29);
    EXPECT_FALSE(stage.judge().solved());
    EXPECT_NEAR(stage.judge().status()[0].progress, 29.0 / 30, 1e-12);
    stage.turn("lamp", false);
    stage.step();
    EXPECT_EQ(stage.judge().status()[0].progress, 0);
    stage.turn("lamp", true);
    stage.step(29);
    EXPECT_FALSE(stage.judge().solved());
    stage.step();
    EXPECT_EQ(stage.judge().solvedFrame(), 60U);
}

TEST(GoalJudge, NamesTheEventsThatMadeAGoalTrue) {
    GoalStage stage(R"({"all": [{"touching": ["metal object", "electromagnet"]},
        {"any": [{"on": "lamp"}, {"on": "lamp 2"}]}, {"not": {"touching": ["crate", "floor"]}},
        {"sequence": [{"on": "electromagnet"}, {"off": "electromagnet"}]}]})");
    stage.touch("metal object", "electromagnet", 11);
    stage.touch("crate", "floor", 12);
    stage.turn("lamp 2", true, 13);
    stage.turn("electromagnet", true, 14);
    stage.step();
    EXPECT_EQ(stage.judge().newlyMet(), (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(stage.judge().causes(stage.world(), 0), (std::vector<EventId>{{11}}));
    EXPECT_EQ(stage.judge().causes(stage.world(), 1), (std::vector<EventId>{{13}}));
    EXPECT_EQ(stage.judge().objects(0),
              (std::vector<ObjectId>{stage.id("electromagnet"), stage.id("metal object")}));
    stage.part("crate", "floor", 15);
    stage.turn("electromagnet", false, 16);
    stage.step();
    EXPECT_EQ(stage.judge().newlyMet(), (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(stage.judge().causes(stage.world(), 2), (std::vector<EventId>{{15}}));
    EXPECT_EQ(stage.judge().causes(stage.world(), 3), (std::vector<EventId>{{14}, {16}}));
    EXPECT_EQ(stage.judge().causes(stage.world()), (std::vector<EventId>{{11}, {13}, {14}, {15}, {16}}));
}

TEST(GoalJudge, SeesStatesThatLastForAPartOfAFrame) {
    GoalStage stage(R"({"all": [{"sequence": [{"on": "lamp"}, {"touching": ["crate", "floor"]}]},
        {"touching": ["metal object", "floor"]}]})");
    stage.stepInParts([&](std::uint32_t part) { stage.turn("lamp", part == 1); });
    EXPECT_FALSE(stage.judge().solved());
    stage.stepInParts([&](std::uint32_t part) {
        if (part == 1) {
            stage.touch("crate", "floor");
        } else {
            stage.part("crate", "floor");
        }
    });
    EXPECT_TRUE(stage.judge().status()[0].met) << "the lamp was on, then the crate touched the floor";
    stage.stepInParts([&](std::uint32_t part) {
        if (part == 1) {
            stage.hit("metal object", "floor");
        }
    });
    EXPECT_EQ(stage.judge().status()[1].frame, 3U);
    EXPECT_EQ(stage.judge().solvedFrame(), 3U);
    EXPECT_TRUE(stage.judge().newlyMet().empty()) << "nothing was newly met in the last part";
}

TEST(GoalJudge, HoldsForTheStatedTimeInPartsToo) {
    GoalStage stage(R"({"on": "lamp", "for": 0.05})"); // three frames
    int frames = 0;
    stage.stepInParts([&](std::uint32_t part) { stage.turn("lamp", part == 4); });
    for (; frames < 10 && !stage.judge().solved(); ++frames) {
        stage.stepInParts([](std::uint32_t) {});
    }
    EXPECT_EQ(frames, 3) << "the time before the first whole frame does not count";
    GoalStage flickering(R"({"on": "lamp", "for": 0.05})");
    for (int i = 0; i < 10; ++i) {
        flickering.stepInParts([&](std::uint32_t part) { flickering.turn("lamp", part == 4); });
    }
    EXPECT_FALSE(flickering.judge().solved()) << "it was off in every frame";
}

TEST(GoalJudge, HasNoStatusWithoutGoals) {
    GoalStage stage("{\"on\": \"lamp\"}");
    LevelFile level;
    GoalJudge judge(level, stage.world());
    stage.step();
    judge.update(stage.world());
    EXPECT_FALSE(judge.solved());
    EXPECT_TRUE(judge.status().empty());
}

/// Conditions on three lamps, evaluated independently on whole histories, for every frame.
struct Formula {
    enum class Kind { lamp, conjunction, disjunction, negation } kind = Kind::lamp;
    int lamp = 0;
    int hold = 1; // frames
    std::vector<Formula> parts;
};

Formula anyFormula(int depth) {
    Formula formula;
    formula.kind = static_cast<Formula::Kind>(*rc::gen::inRange(0, depth > 0 ? 4 : 1));
    formula.lamp = *rc::gen::inRange(0, 3);
    formula.hold = *rc::gen::element(1, 1, 2, 3);
    int const count = formula.kind == Formula::Kind::lamp       ? 0
                      : formula.kind == Formula::Kind::negation ? 1
                                                                : *rc::gen::inRange(1, 4);
    for (int i = 0; i < count; ++i) {
        formula.parts.push_back(anyFormula(depth - 1));
    }
    return formula;
}

constexpr std::array<char const*, 3> lamps{"lamp", "lamp 2", "electromagnet"};

nlohmann::json toJson(Formula const& formula) {
    nlohmann::json json;
    nlohmann::json parts = nlohmann::json::array();
    for (Formula const& part : formula.parts) {
        parts.push_back(toJson(part));
    }
    switch (formula.kind) {
    case Formula::Kind::lamp:
        json["on"] = lamps[static_cast<std::size_t>(formula.lamp)];
        break;
    case Formula::Kind::conjunction:
        json["all"] = parts;
        break;
    case Formula::Kind::disjunction:
        json["any"] = parts;
        break;
    case Formula::Kind::negation:
        json["not"] = parts[0];
        break;
    }
    if (formula.hold > 1) {
        json["for"] = formula.hold / 60.0;
    }
    return json;
}

using History = std::vector<std::array<bool, 3>>;

/// By the definition: it holds at frame f if its condition, without the required duration, held in each of
/// the last `hold` frames.
bool holdsAt(Formula const& formula, History const& history, int frame) {
    if (frame - formula.hold + 1 < 0) {
        return false;
    }
    for (int f = frame - formula.hold + 1; f <= frame; ++f) {
        bool now = formula.kind == Formula::Kind::conjunction;
        switch (formula.kind) {
        case Formula::Kind::lamp:
            now = history[static_cast<std::size_t>(f)][static_cast<std::size_t>(formula.lamp)];
            break;
        case Formula::Kind::conjunction:
            for (Formula const& part : formula.parts) {
                now = now && holdsAt(part, history, f);
            }
            break;
        case Formula::Kind::disjunction:
            for (Formula const& part : formula.parts) {
                now = now || holdsAt(part, history, f);
            }
            break;
        case Formula::Kind::negation:
            now = !holdsAt(formula.parts[0], history, f);
            break;
        }
        if (!now) {
            return false;
        }
    }
    return true;
}

TEST(GoalJudge, AgreesWithTheDefinitionOnWholeHistories) {
    EXPECT_TRUE(rc::check("the judge finds the first frame in which the definition holds", [] {
        Formula const formula = anyFormula(3);
        GoalStage stage(toJson(formula).dump());
        History history;
        std::optional<std::uint64_t> first;
        for (int frame = 0; frame < 12; ++frame) {
            std::array<bool, 3> lit{};
            for (std::size_t i = 0; i < lamps.size(); ++i) {
                lit[i] = *rc::gen::inRange(0, 3) > 0;
                stage.turn(lamps[i], lit[i]);
            }
            history.push_back(lit);
            stage.step();
            if (!first && holdsAt(formula, history, frame)) {
                first = static_cast<std::uint64_t>(frame) + 1;
            }
        }
        RC_ASSERT(stage.judge().solvedFrame() == first);
    }));
}

TEST(GoalJudge, RefusesGoalsThatASmallFileMakesTooLarge) {
    constexpr int crowd = 40;
    Json names = Json::array();
    for (int i = 1; i <= crowd; ++i) {
        names.push_back("one of many " + std::to_string(i));
    }
    Json many = Json::array();
    for (int i = 0; i < 3000; ++i) {
        many.push_back({{"touching", Json::array({"it", names})}});
    }
    Json const goals{{"count", {{"of", names}, {"at_least", 1}, {"that", {{"any", many}}}}}};
    EXPECT_TRUE(isRefused(goals.dump(), "the goals speak of too many objects", crowd));
}

} // namespace
} // namespace goal_judge_test
} // namespace trembler
