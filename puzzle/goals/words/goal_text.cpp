#include "puzzle/goals/words/goal_text.hpp"

#include "puzzle/goals/read_goals.hpp"
#include "puzzle/goals/words/english.hpp"
#include "puzzle/goals/words/lamp.hpp"

#include <algorithm>

namespace trembler {
namespace {

std::string durationWords(Speech const& speech, double seconds) {
    return seconds == 1 ? speech.phrase(" for 1 second")
                        : speech.phrase(" for {} seconds", {{speech.number(seconds)}});
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
    std::string const duration = durationWords(speech_, *condition.seconds);
    if (mood == Mood::avoid) {
        return speech_.phrase("do not {}", {{kind.phrase(condition, *this, Mood::keep, it)}}) + duration;
    }
    return kind.lastingPhrase(condition, *this, it, duration);
}

Noun GoalWords::noun(Selector const& selector, Noun const* it) const {
    if (selector.it && it != nullptr) {
        return *it;
    }
    std::vector<Noun> items;
    for (std::string const& name : selector.names) {
        items.push_back(speech_.the(name));
    }
    for (std::string const& part : selector.parts) {
        items.push_back(speech_.a(part));
    }
    Noun noun = speech_.list(items, "or");
    noun.plural = false;
    return noun;
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

std::vector<std::string> goalSentences(LevelFile const& level, World const& world, Speech const& speech) {
    std::vector<std::string> sentences;
    if (auto const condition = readGoals(level)) {
        GoalWords const words(world, speech);
        for (Condition const& goal : goalsOf(*condition)) {
            sentences.push_back(words.sentence(goal));
        }
    }
    return sentences;
}

} // namespace trembler
