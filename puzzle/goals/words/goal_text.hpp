// Goals in words: "Lift the metal object to the electromagnet", "Keep the lamp lit for 3 seconds".
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

#include <string>

namespace trembler {

/// How a condition is spoken of.
enum class Mood {
    reach, ///< bring it about: "switch on the lamp"
    keep,  ///< let it last: "keep the lamp lit"
    avoid, ///< never let it be: "keep the lamp off"
};
/// That of the opposite condition.
[[nodiscard]] Mood opposite(Mood mood);

/// Whom a phrase is about.
struct Noun {
    std::string words;
    bool plural = false;
};

/// Makes sentences from conditions: what all kinds need for their phrases. Looks at the world for where
/// things are, so that a sentence can say "lift", and for what they are.
class GoalWords {
public:
    explicit GoalWords(World const& world) : world_(world) {}

    /// One sentence for the player, with a capital and without a full stop. The author's own text goes first.
    [[nodiscard]] std::string sentence(Condition const& condition) const;
    /// The condition as a part of a sentence, with the time for which it must hold. `it` is what "it" is
    /// called, null outside a count.
    [[nodiscard]] std::string phrase(Condition const& condition, Mood mood, Noun const* it) const;

    /// What the objects of a selector are called.
    [[nodiscard]] Noun noun(Selector const& selector, Noun const* it) const;
    /// Whether all objects and parts of a selector are lamps (isLamp()), so that they are lit and not
    /// switched on. "it" is not looked at and counts as none.
    [[nodiscard]] bool areLamps(Selector const& selector) const;
    /// The one object of a selector, or an invalid id.
    [[nodiscard]] ObjectId single(Selector const& selector) const;
    [[nodiscard]] World const& world() const { return world_; }

private:
    World const& world_;
};

} // namespace trembler
