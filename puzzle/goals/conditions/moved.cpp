// {"moved": {"object": O, "by": metres, "towards": "up" | "down" | "left" | "right"}}: an object is at least
// that far from its place at the start.
#include "puzzle/goals/checking/candidates.hpp"
#include "puzzle/goals/conditions/acting.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/reading/goal_reader.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"
#include "puzzle/goals/words/goal_text.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trembler::conditions {
namespace {

constexpr double leastDistance = 1e-3;   // m
constexpr double greatestDistance = 1e6; // m

/// A direction, with words for moving an object in this direction and for the place where it then is.
struct Direction {
    std::string_view key; // in a file; empty: any direction
    Vec2 unit;
    std::string_view verb;
    std::string_view adverb;
    std::string_view preposition;
};
constexpr Direction anywhere{"", {}, "move", "", "from"};
constexpr std::array<Direction, 4> directions{{
    {"up", {0, 1}, "lift", "", "above"},
    {"down", {0, -1}, "lower", "", "below"},
    {"left", {-1, 0}, "move", " to the left", "to the left of"},
    {"right", {1, 0}, "move", " to the right", "to the right of"},
}};

std::array<std::string_view, directions.size()> directionKeys() {
    std::array<std::string_view, directions.size()> keys;
    std::transform(directions.begin(), directions.end(), keys.begin(),
                   [](Direction const& direction) { return direction.key; });
    return keys;
}

/// The distance and direction that the file demands.
struct WayToGo {
    double distance = 0; ///< m
    Direction const* towards = &anywhere;
};

/// The memory of a state.
struct StartPlaces {
    std::vector<Vec2> of; ///< m, of the subjects
};

class MovedCondition final : public ConditionKind {
public:
    constexpr MovedCondition() : ConditionKind("moved") {}

    void read(JsonNode const& body, Condition& condition, GoalReader& reader) const override {
        WayToGo way;
        MemberReader members(body, "an object {\"object\", \"by\"}");
        if (auto const object = members.required("object", "the name of an object")) {
            condition.subject = reader.selector(*object);
        }
        if (auto const by = members.required("by", "a distance in m")) {
            way.distance = by->number(leastDistance, greatestDistance).value_or(1);
        }
        if (auto const towards = members.optional("towards")) {
            if (auto const index = towards->choice(directionKeys())) {
                way.towards = &directions[*index];
            }
        }
        members.finish();
        condition.details = way;
    }

    [[nodiscard]] nlohmann::ordered_json schema() const override {
        nlohmann::ordered_json const distance{{"type", "number"},
                                              {"minimum", leastDistance},
                                              {"maximum", greatestDistance},
                                              {"description", "m"}};
        return goal_schema::strictObject(
            {{"object", goal_schema::selector()}, {"by", distance}, {"towards", {{"enum", directionKeys()}}}},
            {"object", "by"});
    }

    [[nodiscard]] std::optional<Impossibility> whyNever(Condition const& condition,
                                                        CandidateFinder const& candidates) const override {
        if (!candidates.areFixed(condition.subject)) {
            return std::nullopt;
        }
        return Impossibility{"a fixed object never moves", "something that can move"};
    }

    void begin(ConditionState& state, ObjectFinder const& finder, ObjectId /*it*/) const override {
        finder.mustHave(state.condition().subject, propertyInfo<Position>(),
                        "is nowhere, so it can never get anywhere");
        StartPlaces starts;
        starts.of.reserve(state.subjects().size());
        for (ObjectId const id : state.subjects()) {
            Position const* const position = finder.world().find<Position>(id);
            starts.of.push_back(position == nullptr ? Vec2{} : position->value);
        }
        state.remember(std::move(starts));
    }

    [[nodiscard]] Standing judge(ConditionState& state, World const& world) const override {
        WayToGo const& wanted = wayOf(state.condition());
        std::vector<ObjectId> const& subjects = state.subjects();
        std::vector<Vec2> const& starts = state.memory<StartPlaces>().of;
        double farthest = 0;
        for (std::size_t i = 0; i < subjects.size(); ++i) {
            if (Position const* const position = world.find<Position>(subjects[i])) { // else destroyed
                Vec2 const way = position->value - starts[i];
                farthest = std::max(farthest, wanted.towards == &anywhere ? length(way)
                                                                          : dot(way, wanted.towards->unit));
            }
        }
        return {farthest >= wanted.distance, std::clamp(farthest / wanted.distance, 0.0, 1.0)};
    }

    void collectCauses(ConditionState const& state, World const& world, bool /*truth*/,
                       std::vector<EventId>& events) const override {
        collectActing(world, state.subjects(), events);
    }

    [[nodiscard]] std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* it) const override {
        Noun const who = words.noun(condition.subject, it);
        WayToGo const& wanted = wayOf(condition);
        Direction const& towards = *wanted.towards;
        std::string const way = fmt::format("{} m", wanted.distance);
        switch (mood) {
        case Mood::reach:
            return fmt::format("{} {}{} by at least {}", towards.verb, who.words, towards.adverb, way);
        case Mood::keep:
            return fmt::format("keep {} at least {} {} where {} at the start", who.words, way,
                               towards.preposition, who.plural ? "they were" : "it was");
        case Mood::avoid:
            break;
        }
        return fmt::format("do not {} {}{} by {} or more", towards.verb, who.words, towards.adverb, way);
    }

private:
    [[nodiscard]] static WayToGo const& wayOf(Condition const& condition) {
        return std::any_cast<WayToGo const&>(condition.details);
    }
};

} // namespace

ConditionKind const& moved() {
    static MovedCondition const kind;
    return kind;
}

} // namespace trembler::conditions
