#include "puzzle/goals/words/goal_text.hpp"

#include "puzzle/goals/words/english.hpp"
#include "puzzle/goals/words/lamp.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

std::string durationWords(double seconds) {
    return seconds == 1 ? std::string("1 second") : fmt::format("{} seconds", seconds);
}

} // namespace

Mood opposite(Mood mood) {
    return mood == Mood::avoid ? Mood::reach : Mood::avoid;
}

std::string GoalWords::sentence(Condition const& condition) const {
    return condition.text.empty() ? capitalised(phrase(condition, Mood::reach, nullptr)) : condition.text;
}

std::string GoalWords::phrase(Condition const& condition, Mood mood, Noun const* it) const {
    if (mood == Mood::reach && !condition.text.empty()) {
        return asClause(condition.text);
    }
    ConditionKind const& kind = *condition.kind;
    if (!condition.seconds) {
        return kind.phrase(condition, *this, mood, it);
    }
    std::string const duration = " for " + durationWords(*condition.seconds);
    if (mood == Mood::avoid) {
        return "do not " + kind.phrase(condition, *this, Mood::keep, it) + duration;
    }
    return kind.lastingPhrase(condition, *this, it, duration);
}

Noun GoalWords::noun(Selector const& selector, Noun const* it) const {
    if (selector.it && it != nullptr) {
        return *it;
    }
    std::vector<std::string> items;
    for (std::string const& name : selector.names) {
        items.push_back(withArticle(name));
    }
    for (std::string const& part : selector.parts) {
        items.push_back(withIndefiniteArticle(part));
    }
    return {enumerated(items, "or"), false};
}

bool GoalWords::areLamps(Selector const& selector) const {
    Store const& store = world_.store();
    auto const isNamedLamp = [&](std::string const& name) { return isLamp(world_, store.find(name)); };
    auto const isPartOfLamps = [&](std::string const& part) {
        PrototypeLibrary const& prototypes = store.prototypes();
        Prototype const* const prototype = prototypes.find(prototypes.numberOf(part));
        return prototype != nullptr && isLamp(*prototype);
    };
    return !selector.empty() && !selector.it &&
           std::all_of(selector.parts.begin(), selector.parts.end(), isPartOfLamps) &&
           std::all_of(selector.names.begin(), selector.names.end(), isNamedLamp);
}

ObjectId GoalWords::single(Selector const& selector) const {
    return selector.names.size() == 1 && selector.parts.empty() ? world_.store().find(selector.names.front())
                                                                : ObjectId{};
}

} // namespace trembler
