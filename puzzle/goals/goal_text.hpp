// Goals in words: "Lift the metal object to the electromagnet", "Keep the lamp lit for 3 seconds".
#pragma once

#include "puzzle/goals/condition.hpp"
#include "runtime/world/world.hpp"

#include <string>

namespace trembler {

/// How a condition is spoken of.
enum class Mood {
    reach, ///< bring it about: "switch on the lamp"
    keep,  ///< let it last: "keep the lamp lit"
    avoid, ///< never let it be: "keep the lamp off"
};

/// Makes sentences from conditions. Looks at the world for where things are, so that a sentence can say
/// "lift".
class GoalWords {
public:
    GoalWords(LevelFile const& level, World const& world) : level_(level), world_(world) {}

    /// One sentence for the player, with a capital and without a full stop. The author's own text goes first.
    [[nodiscard]] std::string sentence(Condition const& condition) const;

private:
    /// Whom a phrase is about.
    struct Noun {
        std::string words;
        bool plural = false;
    };
    [[nodiscard]] std::string phrase(Condition const& condition, Mood mood, Noun const* it) const;
    [[nodiscard]] std::string bare(Condition const& condition, Mood mood, Noun const* it) const;
    [[nodiscard]] std::string insidePhrase(Condition const& condition, Mood mood, Noun const* it) const;
    [[nodiscard]] std::string touchingPhrase(Condition const& condition, Mood mood, Noun const* it) const;
    [[nodiscard]] std::string statePhrase(Condition const& condition, bool on, Mood mood,
                                          Noun const* it) const;
    [[nodiscard]] std::string movedPhrase(Condition const& condition, Mood mood, Noun const* it) const;
    [[nodiscard]] std::string countPhrase(Condition const& condition, Mood mood) const;
    [[nodiscard]] std::string listPhrase(Condition const& condition, Mood mood, Noun const* it) const;
    [[nodiscard]] std::string sequencePhrase(Condition const& condition, Mood mood, Noun const* it) const;

    [[nodiscard]] Noun noun(Selector const& selector, Noun const* it) const;
    [[nodiscard]] Noun counted(Selector const& selector, Quantity quantity, int number) const;
    [[nodiscard]] bool isLamp(Selector const& selector) const;
    /// The one object of a selector, or an invalid id.
    [[nodiscard]] ObjectId single(Selector const& selector) const;

    LevelFile const& level_;
    World const& world_;
};

/// "the lamp"; "object 1" and "Bob" have names of their own and go without.
[[nodiscard]] std::string withArticle(std::string const& name);
/// "a steel bar", "an iron ball".
[[nodiscard]] std::string withIndefiniteArticle(std::string const& noun);
/// "steel balls", "boxes", "batteries".
[[nodiscard]] std::string pluralOf(std::string const& noun);
/// "one" to "twelve", then digits.
[[nodiscard]] std::string numberWord(int number);
/// "a, b and c", with another last word if wanted.
[[nodiscard]] std::string enumerated(std::vector<std::string> const& items, std::string const& last);

} // namespace trembler
