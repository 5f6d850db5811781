// {"count": {"of": O, "at_least" | "at_most" | "exactly": n, "that": condition on "it"}}: the condition holds
// for at least, at most or exactly n of the objects.
#include "puzzle/goals/conditions/count.hpp"

#include "puzzle/goals/checking/candidates.hpp"
#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "puzzle/goals/reading/goal_reader.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"
#include "puzzle/goals/words/goal_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace trembler::conditions {
namespace {

enum class Quantity { atLeast, atMost, exactly };
constexpr std::array<char const*, 3> quantityKeys{"at_least", "at_most", "exactly"};
constexpr std::int64_t greatestNumber = 100000;

/// The number of objects that the file demands.
struct HowMany {
    Quantity quantity = Quantity::atLeast;
    int number = 1;
};

/// A number of the objects of a selector in words: "at least two iron balls", "both the lamp and the bell".
Noun someOf(Speech const& speech, Selector const& selector, HowMany wanted) {
    auto const [quantity, number] = wanted;
    std::string const prefix = quantity == Quantity::atLeast  ? "at least "
                               : quantity == Quantity::atMost ? (number == 0 ? "" : "at most ")
                                                              : "exactly ";
    if (selector.names.empty() && selector.parts.size() == 1) {
        return speech.some(prefix, number, selector.parts.front());
    }
    std::vector<Noun> items;
    for (std::string const& name : selector.names) {
        items.push_back(speech.the(name));
    }
    for (std::string const& part : selector.parts) {
        items.push_back(speech.all(part));
    }
    bool const everybody =
        selector.parts.empty() && number == static_cast<int>(items.size()) && quantity != Quantity::atMost;
    if (everybody) {
        return speech.everyOne(items);
    }
    return speech.someOf(prefix, number, items);
}

class CountCondition final : public ConditionKind {
public:
    constexpr CountCondition() : ConditionKind("count") {}

    void read(JsonNode const& body, Condition& condition, GoalReader& reader) const override {
        MemberReader members(body, "an object {\"of\", \"at_least\", \"that\"}");
        if (!members.valid()) {
            return;
        }
        if (reader.insideCount()) {
            body.complain("is inside another count", "conditions on \"it\" that do not count");
            return;
        }
        if (auto const of = members.required("of", "a list of objects, or {\"part\": name}")) {
            condition.subject = reader.selector(*of);
        }
        HowMany wanted;
        int stated = 0;
        for (std::size_t i = 0; i < quantityKeys.size(); ++i) {
            if (auto const number = members.optional(quantityKeys[i])) {
                ++stated;
                wanted.quantity = static_cast<Quantity>(i);
                wanted.number = static_cast<int>(number->integer(i == 0 ? 1 : 0, greatestNumber).value_or(1));
            }
        }
        if (stated != 1) {
            body.complain(stated == 0 ? "does not state a number" : "states several numbers",
                          "one of \"at_least\", \"at_most\", \"exactly\"");
        }
        if (auto const that = members.required("that", "a condition on \"it\"")) {
            condition.children.push_back(reader.conditionOnIt(*that));
        }
        members.finish();
        condition.details = wanted;
    }

    [[nodiscard]] nlohmann::ordered_json schema() const override {
        nlohmann::ordered_json members{{"of", goal_schema::selector()}, {"that", goal_schema::condition()}};
        for (char const* const quantity : quantityKeys) {
            members[quantity] = {{"type", "integer"}, {"minimum", 0}, {"maximum", greatestNumber}};
        }
        nlohmann::ordered_json body = goal_schema::strictObject(std::move(members), {"of", "that"});
        body["minProperties"] = 3;
        body["maxProperties"] = 3;
        body["description"] = "The number of objects for which the condition \"that\" holds; in it, \"it\" "
                              "refers to the object.";
        return body;
    }

    /// At least one of the objects is inside the area.
    [[nodiscard]] nlohmann::ordered_json draft(ConditionDraft const& with) const override {
        nlohmann::ordered_json that;
        that[std::string(inside().key())] = inside().draft({{"it"}, with.area});
        return {{"of", with.objects}, {"at_least", 1}, {"that", std::move(that)}};
    }

    [[nodiscard]] int countedSteps(Condition const& condition) const override {
        HowMany const wanted = howMany(condition);
        return wanted.quantity == Quantity::atLeast && wanted.number > 1 ? wanted.number : 0;
    }

    [[nodiscard]] std::optional<Impossibility> whyNever(Condition const& condition,
                                                        CandidateFinder const& candidates) const override {
        HowMany const stated = howMany(condition);
        auto const wanted = static_cast<std::size_t>(stated.number);
        std::size_t const possible = candidates.of(condition.subject).size();
        if (stated.quantity == Quantity::atMost || wanted <= possible) {
            return std::nullopt;
        }
        return Impossibility{fmt::format("it demands {} objects, but there can be only {}", wanted, possible),
                             "no more than the level has and the player may place"};
    }

    /// Adds a state of the child for each object that is counted.
    void begin(ConditionState& state, ObjectFinder const& finder, ObjectId /*it*/) const override {
        for (ObjectId const member : state.subjects()) {
            if (!finder.take(0, state.condition().path)) {
                break; // too many objects: take() has complained
            }
            state.addChildren(finder, member);
        }
    }

    [[nodiscard]] Standing judge(ConditionState& state, World const& /*world*/) const override {
        std::span<ConditionState const> const children = std::as_const(state).children();
        auto const number = static_cast<int>(std::count_if(
            children.begin(), children.end(), [](ConditionState const& child) { return child.met(); }));
        HowMany const wanted = howMany(state.condition());
        switch (wanted.quantity) {
        case Quantity::atLeast:
            return {number >= wanted.number, share(number, wanted.number)};
        case Quantity::atMost:
            return {number <= wanted.number, 0};
        case Quantity::exactly:
            break;
        }
        return {number == wanted.number, share(number, wanted.number)};
    }

    [[nodiscard]] std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* /*it*/) const override {
        Condition const& that = condition.children.front();
        HowMany wanted = howMany(condition);
        if (mood == Mood::avoid) { // the opposite of "at least two" is "at most one"
            if (wanted.quantity == Quantity::exactly) {
                Noun const who = someOf(words.speech(), condition.subject, wanted);
                return words.speech().phrase("do not {}", {{words.phrase(that, Mood::reach, &who)}});
            }
            bool const atLeast = wanted.quantity == Quantity::atLeast;
            wanted = {atLeast ? Quantity::atMost : Quantity::atLeast, wanted.number + (atLeast ? -1 : 1)};
            mood = Mood::reach;
        }
        Noun const who = someOf(words.speech(), condition.subject, wanted);
        return words.phrase(that, mood, &who);
    }

private:
    [[nodiscard]] static HowMany howMany(Condition const& condition) {
        return std::any_cast<HowMany>(condition.details);
    }
    [[nodiscard]] static double share(int number, int wanted) {
        return wanted > 0 ? std::min(1.0, static_cast<double>(number) / wanted) : 0;
    }
};

} // namespace

WantedCount wantedCount(Condition const& condition) {
    HowMany const wanted = std::any_cast<HowMany>(condition.details);
    constexpr int unlimited = std::numeric_limits<int>::max();
    return {wanted.quantity == Quantity::atMost ? 0 : wanted.number,
            wanted.quantity == Quantity::atLeast ? unlimited : wanted.number};
}

ConditionKind const& count() {
    static CountCondition const kind;
    return kind;
}

} // namespace trembler::conditions
