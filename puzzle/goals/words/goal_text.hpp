// Goals in words: "Lift the metal object to the electromagnet", "Keep the lamp lit for 3 seconds".
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "puzzle/language/speech.hpp"
#include "runtime/world/world.hpp"

#include <string>
#include <vector>

namespace trembler {

/// The request of a phrase to the player.
enum class Mood {
    reach, ///< make it hold: "switch on the lamp"
    keep,  ///< make it continue to hold: "keep the lamp lit"
    avoid, ///< never let it hold: "keep the lamp off"
};
/// The mood in which the opposite condition has to be phrased.
[[nodiscard]] Mood opposite(Mood mood);

/// Makes sentences from conditions, and provides the functions that the kinds need for their phrases. Reads
/// the places and properties of objects from the world, for example so that a sentence can say "lift".
class GoalWords {
public:
    /// Both must outlive this.
    explicit GoalWords(World const& world, Speech const& speech = englishSpeech())
        : world_(world), speech_(speech) {}

    /// One sentence for the player, with a capital and without a full stop: the text of the level's author if
    /// there is one, else one made from the condition.
    [[nodiscard]] std::string sentence(Condition const& condition) const;
    /// The condition as a part of a sentence, with the time for which it must hold. `it` is the noun for
    /// "it", null outside a count.
    [[nodiscard]] std::string phrase(Condition const& condition, Mood mood, Noun const* it) const;

    /// The noun for the objects of a selector.
    [[nodiscard]] Noun noun(Selector const& selector, Noun const* it) const;
    /// Whether all objects and parts of a selector are lamps (isLamp()), so that a sentence says "light" and
    /// not "switch on". False for "it".
    [[nodiscard]] bool areLamps(Selector const& selector) const;
    /// The one object of a selector, or an invalid id.
    [[nodiscard]] ObjectId single(Selector const& selector) const;
    [[nodiscard]] World const& world() const { return world_; }
    [[nodiscard]] Speech const& speech() const { return speech_; }

private:
    World const& world_;
    Speech const& speech_;
};

/// A sentence for each goal of a level, in the order of GoalJudge::status(), in a world that buildWorld()
/// made from it. Throws InputError if the goals are wrong.
[[nodiscard]] std::vector<std::string> goalSentences(LevelFile const& level, World const& world,
                                                     Speech const& speech);

} // namespace trembler
