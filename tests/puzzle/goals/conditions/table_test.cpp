// Properties of every kind of condition. A body for each is generated from its own schema, so new kinds are
// tested automatically.
#include "puzzle/data/effects.hpp"
#include "puzzle/goals/conditions/table.hpp"
#include "puzzle/goals/goal_judge.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/levels/schema_validator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <sstream>

namespace trembler {
namespace {

using Json = nlohmann::json;

/// Generates the smallest value that a schema accepts; numbers are 1 if allowed. Names of objects are
/// alternately "probe 1" and "probe 2", and "it" in a condition on counted objects.
class SmallestValue {
public:
    explicit SmallestValue(Json const& root) : root_(root) {}

    Json of(Json const& schema) {
        if (schema.contains("$ref")) {
            std::string const place = schema["$ref"].get<std::string>().substr(1);
            if (place == "/$defs/name") {
                odd_ = !odd_;
                return counting_ ? "it" : odd_ ? "probe 1" : "probe 2";
            }
            return of(root_.at(Json::json_pointer(place)));
        }
        for (char const* const choice : {"anyOf", "oneOf", "enum"}) {
            if (schema.contains(choice)) {
                Json const& first = schema[choice][0];
                return choice == std::string_view("enum") ? first : of(first);
            }
        }
        std::string const type = schema.value("type", "");
        if (type == "object") {
            return object(schema);
        }
        if (type == "array") {
            Json list = Json::array();
            for (std::size_t i = 0; i < schema.value("minItems", std::size_t{0}); ++i) {
                list.push_back(of(schema["items"]));
            }
            return list;
        }
        if (type == "integer") {
            return std::clamp(1, schema.value("minimum", 1), schema.value("maximum", 1));
        }
        if (type == "number") {
            return std::clamp(1.0, schema.value("minimum", 1.0), schema.value("maximum", 1.0));
        }
        return type == "boolean" ? Json(true) : Json("words");
    }

private:
    Json object(Json const& schema) {
        Json made = Json::object();
        auto const& members = schema["properties"];
        for (Json const& key : schema.value("required", Json::array())) {
            bool const outside = counting_;
            counting_ = counting_ || key == "that";
            made[key.get<std::string>()] = of(members.at(key.get<std::string>()));
            counting_ = outside;
        }
        for (auto const& [key, member] : members.items()) {
            if (made.size() < schema.value("minProperties", std::size_t{0}) && !made.contains(key)) {
                made[key] = of(member);
            }
        }
        return made;
    }

    Json const& root_;
    bool odd_ = false;
    bool counting_ = false;
};

class ConditionTable : public testing::Test {
protected:
    ConditionTable() {
        registerEffects(registry_);
        schema_ = levelSchema(registry_);
    }

    /// A condition of that kind, as small as its schema allows.
    [[nodiscard]] Json sample(ConditionKind const& kind) const {
        return Json{{std::string(kind.key()), SmallestValue(schema_).of(kind.schema())}};
    }
    /// A level with two objects that every kind of condition accepts, and with these goals.
    [[nodiscard]] static Json level(Json const& goals) {
        Json level = Json::parse(R"({"version": 2, "title": "a level", "objects": [
            {"name": "probe 1", "at": [0, 0], "properties": {"shape": [{"form": "circle", "radius": 0.1}],
             "density": 1000, "conductor": true}}]})");
        level["objects"].push_back(level["objects"][0]);
        level["objects"][1]["name"] = "probe 2";
        level["objects"][1]["at"] = {3, 0};
        level["goals"] = goals;
        return level;
    }
    [[nodiscard]] std::vector<std::string> faults(Json const& goals) const {
        return validate(schema_, level(goals));
    }
    struct Stage {
        LevelFile level;
        std::unique_ptr<World> world;
        std::unique_ptr<GoalJudge> judge;
    };
    [[nodiscard]] Stage stage(Json const& goals) const {
        Stage made;
        made.level = readLevel(registry_, JsonDocument::parse(level(goals).dump(), "level.json"));
        made.world = buildWorld(registry_, made.level, {});
        made.judge = std::make_unique<GoalJudge>(made.level, *made.world);
        return made;
    }
    /// The errors that the reader and the judge find in the goals; "" if none.
    [[nodiscard]] std::string refusal(Json const& goals) const {
        try {
            (void)stage(goals);
            return "";
        } catch (InputError const& error) {
            return error.what();
        }
    }

    Registry registry_;
    Json schema_;
};

TEST_F(ConditionTable, HasEachKeyOnceInCodeSchemaAndDocument) {
    std::ifstream file(std::string(TREMBLER_SOURCE_DIR) + "/docs/designers.md");
    std::ostringstream document;
    document << file.rdbuf();
    std::set<std::string> keys;
    for (ConditionKind const* const kind : conditionKinds()) {
        std::string const key(kind->key());
        EXPECT_TRUE(keys.insert(key).second) << key;
        EXPECT_NE(document.str().find("`{\"" + key + "\": "), std::string::npos)
            << key << " has no row in docs/designers.md";
    }
    for (char const* const taken : {"for", "id", "text", "it"}) {
        EXPECT_FALSE(keys.contains(taken)) << taken;
    }
    std::set<std::string> published;
    for (Json const& one : schema_["$defs"]["condition"]["oneOf"]) {
        published.insert(one["required"][0].get<std::string>());
    }
    EXPECT_EQ(published, keys);
}

TEST_F(ConditionTable, EveryKindReadsWhatItsSchemaAccepts) {
    for (ConditionKind const* const kind : conditionKinds()) {
        Json const goals = sample(*kind);
        EXPECT_EQ(faults(goals), std::vector<std::string>()) << goals;
        EXPECT_EQ(refusal(goals), "") << goals;
        LevelFile const read = readLevel(registry_, JsonDocument::parse(level(goals).dump(), "level.json"));
        EXPECT_EQ(readGoals(read)->kind, kind) << goals;
    }
}

TEST_F(ConditionTable, EveryKindIsDraftedAsItsSchemaAccepts) {
    for (ConditionKind const* const kind : conditionKinds()) {
        ASSERT_LE(kind->draftObjects(), 2U);
        ConditionDraft const with{{"probe 1", "probe 2"}, {0, 0, 1, 1}};
        Json const goals{{std::string(kind->key()), Json(kind->draft(with))}};
        EXPECT_EQ(faults(goals), std::vector<std::string>()) << goals;
        EXPECT_EQ(refusal(goals), "") << goals;
    }
}

TEST_F(ConditionTable, EveryKindRefusesWhatItsSchemaRefuses) {
    for (ConditionKind const* const kind : conditionKinds()) {
        std::string const key(kind->key());
        std::vector<Json> wrong;
        for (char const* const body : {"null", "true", "-1", "\"\"", "{}", "[]", R"({"surprise": 1})"}) {
            wrong.push_back(Json{{key, Json::parse(body)}});
        }
        Json const right = sample(*kind);
        wrong.push_back(right);
        wrong.back()["surprise"] = 1;
        wrong.push_back(right);
        wrong.back()["for"] = "long";
        if (right[key].is_object()) {
            for (auto const& [member, value] : right[key].items()) {
                wrong.push_back(right);
                wrong.back()[key].erase(member);
                wrong.push_back(right);
                wrong.back()[key][member] = nullptr;
            }
        }
        for (Json const& goals : wrong) {
            EXPECT_FALSE(faults(goals).empty()) << goals;
            EXPECT_NE(refusal(goals), "") << goals;
        }
    }
}

TEST_F(ConditionTable, EveryKindHasDifferentTextsForReachingKeepingAndAvoiding) {
    for (ConditionKind const* const kind : conditionKinds()) {
        Json const plain = sample(*kind);
        Json lasting = plain;
        lasting["for"] = 2;
        std::set<std::string> sentences;
        for (Json const& goals : {plain, lasting, Json{{"not", plain}}, Json{{"not", lasting}}}) {
            Stage const made =
                stage({{"any", Json::array({goals})}}); // one goal, even if the condition lists several
            ASSERT_EQ(made.judge->status().size(), 1U);
            std::string const text = made.judge->status()[0].text;
            ASSERT_FALSE(text.empty()) << goals;
            EXPECT_TRUE(text[0] >= 'A' && text[0] <= 'Z') << text;
            EXPECT_NE(text.back(), '.') << text;
            EXPECT_EQ(text.find("  "), std::string::npos) << text;
            EXPECT_TRUE(sentences.insert(text).second) << text << " is the text of two different goals";
        }
    }
}

TEST_F(ConditionTable, EveryKindIsJudgedOnAWorld) {
    for (ConditionKind const* const kind : conditionKinds()) {
        Json const goals = sample(*kind);
        Stage made = stage(goals);
        bool const holdsAtFirst = [&] {
            made.world->step();
            made.judge->update(*made.world);
            return made.judge->solved();
        }();
        Stage opposite = stage({{"not", goals}});
        opposite.world->step();
        opposite.judge->update(*opposite.world);
        EXPECT_NE(holdsAtFirst, opposite.judge->solved()) << goals;
        for (std::size_t i = 0; i < made.judge->status().size(); ++i) {
            GoalStatus const& status = made.judge->status()[i];
            EXPECT_GE(status.progress, 0) << goals;
            EXPECT_LE(status.progress, 1) << goals;
            EXPECT_EQ(made.judge->objects(i).empty(), false) << goals;
        }
    }
}

} // namespace
} // namespace trembler
