// {"inside": {"object": O, "area": [x, y, width, height] or [[x, y], ...], "called": "the basket"}}: the
// centre of an object lies in the area.
#include "puzzle/goals/checking/candidates.hpp"
#include "puzzle/goals/conditions/acting.hpp"
#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/reading/goal_reader.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"
#include "puzzle/goals/words/goal_text.hpp"
#include "runtime/level/read/read_area.hpp"
#include "runtime/placement.hpp"

#include <algorithm>

namespace trembler::conditions {
namespace {

class InsideCondition final : public ConditionKind {
public:
    constexpr InsideCondition() : ConditionKind("inside") {}

    void read(JsonNode const& body, Condition& condition, GoalReader& reader) const override {
        MemberReader members(body, "an object {\"object\", \"area\"}");
        if (auto const object = members.required("object", "the name of an object")) {
            condition.subject = reader.selector(*object);
        }
        if (auto const area = members.required("area", "a box [x, y, width, height] or a polygon, in m")) {
            condition.area = readArea(*area);
        }
        if (auto const called = members.optional("called")) {
            condition.areaName = called->name("name of the area in texts for the player").value_or("");
        }
        members.finish();
    }

    [[nodiscard]] nlohmann::ordered_json schema() const override {
        return goal_schema::strictObject(
            {{"object", goal_schema::selector()},
             {"area", goal_schema::reference("area")},
             {"called", {{"type", "string"}, {"description", "name of the area in texts for the player"}}}},
            {"object", "area"});
    }

    [[nodiscard]] std::optional<Impossibility> whyNever(Condition const& condition,
                                                        CandidateFinder const& candidates) const override {
        if (!candidates.areFixed(condition.subject)) {
            return std::nullopt;
        }
        World const& world = candidates.world();
        Candidates const all = candidates.of(condition.subject);
        bool const isThere = std::any_of(all.names.begin(), all.names.end(), [&](std::string const& name) {
            return liesIn(*condition.area, world, world.store().find(name));
        });
        if (isThere) {
            return std::nullopt;
        }
        return Impossibility{"a fixed object never gets there",
                             "something that can move, or an area around it"};
    }

    [[nodiscard]] nlohmann::ordered_json draft(ConditionDraft const& with) const override {
        return {{"object", with.objects[0]}, {"area", with.area}};
    }

    void begin(ConditionState& state, ObjectFinder const& finder, ObjectId /*it*/) const override {
        finder.mustHave(state.condition().subject, propertyInfo<Position>(),
                        "is nowhere, so it can never get anywhere");
    }

    [[nodiscard]] Standing judge(ConditionState& state, World const& world) const override {
        return {std::any_of(state.subjects().begin(), state.subjects().end(),
                            [&](ObjectId id) { return liesIn(*state.condition().area, world, id); }),
                0};
    }

    void collectCauses(ConditionState const& state, World const& world, bool /*truth*/,
                       std::vector<EventId>& events) const override {
        collectActing(world, state.subjects(), events);
    }

    [[nodiscard]] std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* it) const override {
        Noun const who = words.noun(condition.subject, it);
        Noun const area = words.speech().area(condition.areaName);
        switch (mood) {
        case Mood::reach:
            return words.speech().phrase("bring {} into {}", {who, area});
        case Mood::keep:
            return words.speech().phrase("keep {} in {}", {who, area});
        case Mood::avoid:
            break;
        }
        return words.speech().phrase("keep {} out of {}", {who, area});
    }

private:
    [[nodiscard]] static bool liesIn(Area const& area, World const& world, ObjectId id) {
        Position const* const position = world.find<Position>(id);
        return position != nullptr && area.contains(position->value);
    }
};

} // namespace

ConditionKind const& inside() {
    static InsideCondition const kind;
    return kind;
}

} // namespace trembler::conditions
