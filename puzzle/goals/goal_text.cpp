#include "puzzle/goals/goal_text.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace trembler {
namespace {

bool isUpper(char c) {
    return c >= 'A' && c <= 'Z';
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isVowel(char c) {
    return std::string_view("aeiouAEIOU").find(c) != std::string_view::npos;
}

std::string capitalised(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
        text[0] = static_cast<char>(text[0] - 'a' + 'A');
    }
    return text;
}

/// An author's sentence as a part of a longer one.
std::string asClause(std::string text) {
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) {
        text.pop_back();
    }
    if (text.size() > 1 && isUpper(text[0]) && !isUpper(text[1])) { // not "LED ..."
        text[0] = static_cast<char>(text[0] - 'A' + 'a');
    }
    return text;
}

std::string measure(double value) {
    return fmt::format("{}", value);
}

std::string durationWords(double seconds) {
    return seconds == 1 ? std::string("1 second") : fmt::format("{} seconds", measure(seconds));
}

Mood opposite(Mood mood) {
    return mood == Mood::avoid ? Mood::reach : Mood::avoid;
}

bool isGroup(Condition const& condition) {
    return condition.text.empty() && condition.children.size() > 1 &&
           (condition.kind == ConditionKind::all || condition.kind == ConditionKind::any ||
            condition.kind == ConditionKind::sequence);
}

/// How something is moved in a direction, and how it then lies to where it was.
struct DirectionWords {
    std::string_view verb;
    std::string_view adverb;
    std::string_view preposition;
};

DirectionWords wordsFor(Towards towards) {
    switch (towards) {
    case Towards::up:
        return {"lift", "", "above"};
    case Towards::down:
        return {"lower", "", "below"};
    case Towards::left:
        return {"move", " to the left", "to the left of"};
    case Towards::right:
        return {"move", " to the right", "to the right of"};
    case Towards::anywhere:
        break;
    }
    return {"move", "", "from"};
}

} // namespace

std::string withArticle(std::string const& name) {
    bool const own = name.empty() || isUpper(name[0]) || isDigit(name.back()) || name.starts_with("the ");
    return own ? name : "the " + name;
}

std::string withIndefiniteArticle(std::string const& noun) {
    return (!noun.empty() && isVowel(noun[0]) ? "an " : "a ") + noun;
}

std::string pluralOf(std::string const& noun) {
    if (noun.empty() || std::isalpha(static_cast<unsigned char>(noun.back())) == 0) {
        return noun; // "battery +"
    }
    auto const endsWith = [&](std::string_view end) { return noun.ends_with(end); };
    if (endsWith("s") || endsWith("x") || endsWith("ch") || endsWith("sh")) {
        return noun + "es";
    }
    if (endsWith("y") && noun.size() > 1 && !isVowel(noun[noun.size() - 2])) {
        return noun.substr(0, noun.size() - 1) + "ies";
    }
    return noun + "s";
}

std::string numberWord(int number) {
    constexpr std::array<std::string_view, 13> words{"no",   "one",    "two",   "three", "four",
                                                     "five", "six",    "seven", "eight", "nine",
                                                     "ten",  "eleven", "twelve"};
    return number >= 0 && number < static_cast<int>(words.size())
               ? std::string(words[static_cast<std::size_t>(number)])
               : std::to_string(number);
}

std::string enumerated(std::vector<std::string> const& items, std::string const& last) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) {
            text += i + 1 == items.size() ? " " + last + " " : ", ";
        }
        text += items[i];
    }
    return text;
}

std::string GoalWords::sentence(Condition const& condition) const {
    return condition.text.empty() ? capitalised(phrase(condition, Mood::reach, nullptr)) : condition.text;
}

std::string GoalWords::phrase(Condition const& condition, Mood mood, Noun const* it) const {
    if (mood == Mood::reach && !condition.text.empty()) {
        return asClause(condition.text);
    }
    if (!condition.seconds) {
        return bare(condition, mood, it);
    }
    std::string const duration = " for " + durationWords(*condition.seconds);
    if (mood == Mood::avoid) {
        return "do not " + bare(condition, Mood::keep, it) + duration;
    }
    if (condition.kind == ConditionKind::sequence) { // done once, it stays done
        return bare(condition, Mood::reach, it) + ", then wait" + duration;
    }
    std::string const between = !isGroup(condition)                    ? ""
                                : condition.kind == ConditionKind::any ? ", either of it"
                                : condition.children.size() == 2       ? ", both"
                                                                       : ", all of it";
    return bare(condition, Mood::keep, it) + between + duration;
}

std::string GoalWords::bare(Condition const& condition, Mood mood, Noun const* it) const {
    switch (condition.kind) {
    case ConditionKind::inside:
        return insidePhrase(condition, mood, it);
    case ConditionKind::touching:
        return touchingPhrase(condition, mood, it);
    case ConditionKind::on:
        return statePhrase(condition, true, mood, it);
    case ConditionKind::off:
        return statePhrase(condition, false, mood, it);
    case ConditionKind::moved:
        return movedPhrase(condition, mood, it);
    case ConditionKind::count:
        return countPhrase(condition, mood);
    case ConditionKind::all:
    case ConditionKind::any:
        return listPhrase(condition, mood, it);
    case ConditionKind::sequence:
        return sequencePhrase(condition, mood, it);
    case ConditionKind::negation:
        return phrase(condition.children.front(), opposite(mood), it);
    }
    return "";
}

std::string GoalWords::insidePhrase(Condition const& condition, Mood mood, Noun const* it) const {
    std::string const who = noun(condition.subject, it).words;
    switch (mood) {
    case Mood::reach:
        return fmt::format("bring {} into {}", who, condition.areaName);
    case Mood::keep:
        return fmt::format("keep {} in {}", who, condition.areaName);
    case Mood::avoid:
        break;
    }
    return fmt::format("keep {} out of {}", who, condition.areaName);
}

std::string GoalWords::touchingPhrase(Condition const& condition, Mood mood, Noun const* it) const {
    Selector const* mover = &condition.subject;
    Selector const* target = &condition.object;
    // Who is fixed cannot be brought anywhere.
    if (world_.find<Fixed>(single(*mover)) != nullptr && world_.find<Fixed>(single(*target)) == nullptr) {
        std::swap(mover, target);
    }
    std::string const who = noun(*mover, it).words;
    std::string const what = noun(*target, it).words;
    switch (mood) {
    case Mood::reach: {
        Position const* const from = world_.find<Position>(single(*mover));
        Position const* const to = world_.find<Position>(single(*target));
        if (from != nullptr && to != nullptr) {
            Vec2 const way = to->value - from->value;
            if (std::abs(way.y) > std::abs(way.x)) {
                return way.y > 0 ? fmt::format("lift {} to {}", who, what)
                                 : fmt::format("bring {} down to {}", who, what);
            }
        }
        return fmt::format("bring {} to {}", who, what);
    }
    case Mood::keep:
        return fmt::format("keep {} touching {}", who, what);
    case Mood::avoid:
        break;
    }
    return fmt::format("keep {} away from {}", who, what);
}

std::string GoalWords::statePhrase(Condition const& condition, bool on, Mood mood, Noun const* it) const {
    std::string const who = noun(condition.subject, it).words;
    bool const wanted = on != (mood == Mood::avoid);
    bool const lamp = isLamp(condition.subject);
    if (mood == Mood::reach) {
        char const* const verb = wanted ? (lamp ? "light" : "switch on") : (lamp ? "put out" : "switch off");
        return fmt::format("{} {}", verb, who);
    }
    return fmt::format("keep {} {}", who, wanted ? (lamp ? "lit" : "on") : (lamp ? "dark" : "off"));
}

std::string GoalWords::movedPhrase(Condition const& condition, Mood mood, Noun const* it) const {
    Noun const who = noun(condition.subject, it);
    std::string const way = measure(condition.distance) + " m";
    DirectionWords const words = wordsFor(condition.towards);
    switch (mood) {
    case Mood::reach:
        return fmt::format("{} {}{} by at least {}", words.verb, who.words, words.adverb, way);
    case Mood::keep:
        return fmt::format("keep {} at least {} {} where {} at the start", who.words, way, words.preposition,
                           who.plural ? "they were" : "it was");
    case Mood::avoid:
        break;
    }
    return fmt::format("do not {} {}{} by {} or more", words.verb, who.words, words.adverb, way);
}

std::string GoalWords::countPhrase(Condition const& condition, Mood mood) const {
    Condition const& that = condition.children.front();
    Quantity quantity = condition.quantity;
    int number = condition.number;
    if (mood == Mood::avoid) { // not "at least two" is "at most one"
        if (quantity == Quantity::exactly) {
            Noun const who = counted(condition.subject, quantity, number);
            return "do not " + phrase(that, Mood::reach, &who);
        }
        number += quantity == Quantity::atLeast ? -1 : 1;
        quantity = quantity == Quantity::atLeast ? Quantity::atMost : Quantity::atLeast;
        mood = Mood::reach;
    }
    Noun const who = counted(condition.subject, quantity, number);
    return phrase(that, mood, &who);
}

std::string GoalWords::listPhrase(Condition const& condition, Mood mood, Noun const* it) const {
    std::vector<std::string> phrases;
    bool nested = false;
    for (Condition const& child : condition.children) {
        phrases.push_back(phrase(child, mood, it));
        nested = nested || isGroup(child) || child.kind == ConditionKind::negation;
    }
    // Not "both" is "either not the one or not the other", and the other way round (De Morgan).
    bool const conjunction = (condition.kind == ConditionKind::all) != (mood == Mood::avoid);
    if (nested && phrases.size() > 1) {
        for (std::size_t i = 0; i + 2 < phrases.size(); ++i) {
            phrases[i] += ";";
        }
        std::string text;
        for (std::size_t i = 0; i < phrases.size(); ++i) {
            text += i == 0 ? "" : (i + 1 == phrases.size() ? (conjunction ? ", and " : ", or ") : " ");
            text += phrases[i];
        }
        return conjunction ? text : "either " + text;
    }
    std::string const text = enumerated(phrases, conjunction ? "and" : "or");
    return conjunction || phrases.size() == 1 ? text : "either " + text;
}

std::string GoalWords::sequencePhrase(Condition const& condition, Mood mood, Noun const* it) const {
    std::string text;
    for (std::size_t i = 0; i < condition.children.size(); ++i) {
        std::string const step = phrase(condition.children[i], Mood::reach, it);
        text += condition.children.size() == 1 ? step : (i == 0 ? "first " + step : ", then " + step);
    }
    return mood == Mood::avoid ? "do not " + text : text;
}

GoalWords::Noun GoalWords::noun(Selector const& selector, Noun const* it) const {
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

GoalWords::Noun GoalWords::counted(Selector const& selector, Quantity quantity, int number) const {
    std::string const prefix = quantity == Quantity::atLeast  ? "at least "
                               : quantity == Quantity::atMost ? (number == 0 ? "" : "at most ")
                                                              : "exactly ";
    bool const plural = number != 1;
    if (selector.names.empty() && selector.parts.size() == 1) {
        std::string const& part = selector.parts.front();
        return {prefix + numberWord(number) + " " + (plural ? pluralOf(part) : part), plural};
    }
    std::vector<std::string> items;
    for (std::string const& name : selector.names) {
        items.push_back(withArticle(name));
    }
    for (std::string const& part : selector.parts) {
        items.push_back("the " + pluralOf(part));
    }
    bool const everybody =
        selector.parts.empty() && number == static_cast<int>(items.size()) && quantity != Quantity::atMost;
    if (everybody && items.size() == 2) {
        return {"both " + enumerated(items, "and"), true};
    }
    if (everybody) {
        return {items.size() == 1 ? items.front() : "all of " + enumerated(items, "and"), items.size() > 1};
    }
    return {prefix + (number == 0 ? "none" : numberWord(number)) + " of " + enumerated(items, "and"), plural};
}

bool GoalWords::isLamp(Selector const& selector) const {
    auto const isWordLamp = [](std::string const& name) { return name == "lamp" || name.ends_with(" lamp"); };
    bool all = !selector.empty() && !selector.it;
    for (std::string const& part : selector.parts) {
        all = all && isWordLamp(part);
    }
    for (std::string const& name : selector.names) {
        LevelObject const* const object = level_.findObject(name);
        all = all && object != nullptr && (isWordLamp(object->part) || isWordLamp(name));
    }
    return all;
}

ObjectId GoalWords::single(Selector const& selector) const {
    return selector.names.size() == 1 && selector.parts.empty() ? world_.store().find(selector.names.front())
                                                                : ObjectId{};
}

} // namespace trembler
