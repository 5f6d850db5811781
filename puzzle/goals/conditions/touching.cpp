// {"touching": [O, O]}: an object of the first selector touches one of the second. A touch that lasts only a
// part of a frame counts.
#include "puzzle/goals/conditions/touching.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "puzzle/goals/checking/whole_level.hpp"
#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/reading/goal_reader.hpp"
#include "puzzle/goals/reading/schema_pieces.hpp"
#include "puzzle/goals/words/goal_text.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace trembler::conditions {
namespace {

/// The memory of a state.
struct LastContact {
    EventId ended; ///< when the last contact ended
};

/// The contact of two objects, or nullptr.
TouchingPair const* findPair(std::vector<TouchingPair> const& pairs, ObjectId a, ObjectId b) {
    TouchingPair const wanted{std::min(a, b), std::max(a, b), {}};
    auto const at = std::lower_bound(pairs.begin(), pairs.end(), wanted);
    return at != pairs.end() && *at == wanted ? &*at : nullptr;
}

/// Calls f(a, b, pair) for every contact of one of the state's subjects with one of its objects; both lists
/// are ascending. Looks up either each pair of objects or each contact, whichever are fewer.
template <class F>
void forContacts(std::vector<TouchingPair> const& pairs, ConditionState const& state, F&& f) {
    std::vector<ObjectId> const& as = state.subjects();
    std::vector<ObjectId> const& bs = state.objects();
    if (bs.empty() || as.size() <= pairs.size() / bs.size()) {
        for (ObjectId const a : as) {
            for (ObjectId const b : bs) {
                if (TouchingPair const* const pair = findPair(pairs, a, b)) {
                    f(a, b, *pair);
                }
            }
        }
        return;
    }
    auto const isOneOf = [](std::vector<ObjectId> const& all, ObjectId id) {
        return std::binary_search(all.begin(), all.end(), id);
    };
    for (TouchingPair const& pair : pairs) {
        if (isOneOf(as, pair.a) && isOneOf(bs, pair.b)) {
            f(pair.a, pair.b, pair);
        }
        if (isOneOf(as, pair.b) && isOneOf(bs, pair.a)) {
            f(pair.b, pair.a, pair);
        }
    }
}

class TouchingCondition final : public ConditionKind {
public:
    constexpr TouchingCondition() : ConditionKind("touching") {}

    void read(JsonNode const& body, Condition& condition, GoalReader& reader) const override {
        if (!body.value().is_array() || body.size() != 2) {
            body.complainOfType("a list of two selectors");
            return;
        }
        condition.subject = reader.selector(body.element(0));
        condition.object = reader.selector(body.element(1));
    }

    [[nodiscard]] nlohmann::ordered_json schema() const override {
        return {{"type", "array"}, {"items", goal_schema::selector()}, {"minItems", 2}, {"maxItems", 2}};
    }

    [[nodiscard]] std::optional<Impossibility> whyNever(Condition const& condition,
                                                        CandidateFinder const& candidates) const override {
        Candidates both;
        candidates.add(both, condition.subject);
        candidates.add(both, condition.object);
        if (both.size() != 1) {
            return std::nullopt;
        }
        return Impossibility{"nothing touches itself", "two different objects"};
    }

    [[nodiscard]] nlohmann::ordered_json draft(ConditionDraft const& with) const override {
        return nlohmann::ordered_json::array({with.objects[0], with.objects[1]});
    }
    [[nodiscard]] std::size_t draftObjects() const override { return 2; }

    [[nodiscard]] std::vector<Impossibility> whyHopeless(Condition const& condition,
                                                         WholeLevel const& level) const override {
        if (level.candidates.areFixed(condition.subject) && level.candidates.areFixed(condition.object)) {
            return {{"fixed objects never come to touch one another", "something that can move"}};
        }
        return {};
    }

    void begin(ConditionState& state, ObjectFinder const& finder, ObjectId /*it*/) const override {
        for (Selector const* const selector : {&state.condition().subject, &state.condition().object}) {
            finder.mustHave(*selector, propertyInfo<Shape>(), "has no shape, so it can never touch anything");
        }
        state.remember(LastContact{});
    }

    [[nodiscard]] Standing judge(ConditionState& state, World const& world) const override {
        auto const* const contacts = world.find<Contacts>();
        if (contacts == nullptr) {
            return {};
        }
        // A contact that ends within the frame counts as a touch, too.
        bool any = false;
        forContacts(contacts->current, state, [&](ObjectId, ObjectId, TouchingPair const&) { any = true; });
        // The contact that has ended; of several, that of the last pair in the order of the objects.
        std::pair<ObjectId, ObjectId> last;
        TouchingPair const* ended = nullptr;
        auto const note = [&](ObjectId a, ObjectId b, TouchingPair const& pair) {
            if (ended == nullptr || std::pair(a, b) >= last) {
                last = {a, b};
                ended = &pair;
            }
        };
        forContacts(contacts->ended, state, note);
        forContacts(contacts->brief, state, [&](ObjectId a, ObjectId b, TouchingPair const& pair) {
            any = true;
            note(a, b, pair);
        });
        if (ended != nullptr) {
            state.memory<LastContact>().ended = ended->event;
        }
        return {any, 0};
    }

    void collectCauses(ConditionState const& state, World const& world, bool truth,
                       std::vector<EventId>& events) const override {
        if (!truth) {
            events.push_back(state.memory<LastContact>().ended);
            return;
        }
        auto const* const contacts = world.find<Contacts>();
        if (contacts == nullptr) {
            return;
        }
        std::set<std::pair<ObjectId, ObjectId>> lasting;
        forContacts(contacts->current, state, [&](ObjectId a, ObjectId b, TouchingPair const& pair) {
            lasting.emplace(a, b);
            events.push_back(pair.event);
        });
        forContacts(contacts->brief, state, [&](ObjectId a, ObjectId b, TouchingPair const& pair) {
            if (!lasting.contains({a, b})) {
                events.push_back(pair.event);
            }
        });
    }

    [[nodiscard]] std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                     Noun const* it) const override {
        Selector const* mover = &condition.subject;
        Selector const* target = &condition.object;
        // A fixed object cannot be moved, so the player must bring the other object to it.
        World const& world = words.world();
        if (world.find<Fixed>(words.single(*mover)) != nullptr &&
            world.find<Fixed>(words.single(*target)) == nullptr) {
            std::swap(mover, target);
        }
        Noun const who = words.noun(*mover, it);
        Noun const what = words.noun(*target, it);
        switch (mood) {
        case Mood::reach:
            return words.speech().phrase(bringing(world, words.single(*mover), words.single(*target)),
                                         {who, what});
        case Mood::keep:
            return words.speech().phrase("keep {} touching {}", {who, what});
        case Mood::avoid:
            break;
        }
        return words.speech().phrase("keep {} away from {}", {who, what});
    }

private:
    /// The phrase for bringing `mover` to `target`. An id is invalid if its selector refers to several
    /// objects.
    [[nodiscard]] static std::string_view bringing(World const& world, ObjectId mover, ObjectId target) {
        Position const* const from = world.find<Position>(mover);
        Position const* const to = world.find<Position>(target);
        if (from == nullptr || to == nullptr) {
            return "bring {} to {}";
        }
        Vec2 const way = to->value - from->value;
        if (std::abs(way.y) <= std::abs(way.x)) {
            return "bring {} to {}";
        }
        return way.y > 0 ? "lift {} to {}" : "bring {} down to {}";
    }
};

} // namespace

std::vector<std::pair<ObjectId, ObjectId>> wantedTouches(ConditionState const& state,
                                                         Contacts const& contacts) {
    std::map<std::pair<ObjectId, ObjectId>, std::pair<ObjectId, ObjectId>> found; // by contact
    for (auto const* const pairs : {&contacts.current, &contacts.brief}) {
        forContacts(*pairs, state, [&](ObjectId a, ObjectId b, TouchingPair const& pair) {
            found.try_emplace({pair.a, pair.b}, a, b);
        });
    }
    std::vector<std::pair<ObjectId, ObjectId>> touches;
    for (auto const& [contact, touch] : found) {
        touches.push_back(touch);
    }
    return touches;
}

ConditionKind const& touching() {
    static TouchingCondition const kind;
    return kind;
}

} // namespace trembler::conditions
