// {"moved": {"object": O, "by": metres, "towards": "up" | "down" | "left" | "right"}}: an object is at least
// that far from its place at the start.
#include "puzzle/goals/conditions/moved.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "puzzle/goals/checking/whole_level.hpp"
#include "puzzle/goals/conditions/acting.hpp"
#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/reading/goal_reader.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"
#include "puzzle/goals/words/goal_text.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <array>

namespace trembler::conditions {
namespace {

constexpr double leastDistance = 1e-3;   // m
constexpr double greatestDistance = 1e6; // m

/// A direction, with phrases for moving an object in this direction, for the place where it then is, and for
/// not moving it there: the object, and how far.
struct Direction {
    std::string_view key; // in a file; empty: any direction
    Vec2 unit;
    std::string_view reach;
    std::string_view keep;
    std::string_view avoid;
};
constexpr Direction anywhere{"",
                             {},
                             "move {} by at least {}",
                             "keep {} at least {} from where it was at the start",
                             "do not move {} by {} or more"};
constexpr std::array<Direction, 4> directions{{
    {"up",
     {0, 1},
     "lift {} by at least {}",
     "keep {} at least {} above where it was at the start",
     "do not lift {} by {} or more"},
    {"down",
     {0, -1},
     "lower {} by at least {}",
     "keep {} at least {} below where it was at the start",
     "do not lower {} by {} or more"},
    {"left",
     {-1, 0},
     "move {} to the left by at least {}",
     "keep {} at least {} to the left of where it was at the start",
     "do not move {} to the left by {} or more"},
    {"right",
     {1, 0},
     "move {} to the right by at least {}",
     "keep {} at least {} to the right of where it was at the start",
     "do not move {} to the right by {} or more"},
}};
/// The end of "keep", for one object and for several.
constexpr std::string_view itWas = "it was at the start";
constexpr std::string_view theyWere = "they were at the start";

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

    [[nodiscard]] nlohmann::ordered_json draft(ConditionDraft const& with) const override {
        return {{"object", with.objects[0]}, {"by", 1}};
    }

    /// An object without a body and a velocity stays where it is.
    [[nodiscard]] std::vector<Impossibility> whyHopeless(Condition const& condition,
                                                         WholeLevel const& level) const override {
        World const& world = level.world;
        Candidates const all = level.candidates.of(condition.subject);
        bool const moves =
            all.it || all.placed > 0 || all.names.empty() ||
            std::any_of(all.names.begin(), all.names.end(), [&](std::string const& name) {
                ObjectId const id = world.store().find(name);
                return !id.valid() || world.find<Shape>(id) != nullptr || world.find<Velocity>(id) != nullptr;
            });
        if (moves) {
            return {};
        }
        return {{"an object without a shape never moves", "something that has a shape"}};
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
        Speech const& speech = words.speech();
        Noun const way{speech.number(wanted.distance) + " m"};
        switch (mood) {
        case Mood::reach:
            return speech.phrase(towards.reach, {who, way});
        case Mood::keep: {
            std::string keep(towards.keep);
            if (who.plural) {
                keep.replace(keep.size() - itWas.size(), itWas.size(), theyWere);
            }
            return speech.phrase(keep, {who, way});
        }
        case Mood::avoid:
            break;
        }
        return speech.phrase(towards.avoid, {who, way});
    }

private:
    [[nodiscard]] static WayToGo const& wayOf(Condition const& condition) {
        return std::any_cast<WayToGo const&>(condition.details);
    }
};

} // namespace

WantedMove wantedMove(Condition const& condition) {
    WayToGo const& way = std::any_cast<WayToGo const&>(condition.details);
    return {way.distance, way.towards->unit};
}

ConditionKind const& moved() {
    static MovedCondition const kind;
    return kind;
}

nlohmann::ordered_json movedDraft(ConditionDraft const& with) {
    nlohmann::ordered_json condition;
    condition[std::string(moved().key())] = moved().draft(with);
    return condition;
}

} // namespace trembler::conditions
