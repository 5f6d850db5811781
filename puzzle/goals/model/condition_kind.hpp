// What a kind of goal condition ("inside", "touching", "all" ...) states about itself. Each kind is one file
// in conditions/ and one line in the table there; everything else asks the kind.
#pragma once

#include "runtime/object/object_id.hpp"
#include "runtime/trace/event.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trembler {

class CandidateFinder;
class ConditionState;
class GoalReader;
class GoalWords;
class JsonNode;
class ObjectFinder;
class World;
enum class Mood;
struct Condition;
struct Noun;

/// How a condition stands at present.
struct Standing {
    bool holds = false;  ///< leaving aside for how long
    double progress = 0; ///< 0 to 1: how much of it is done; counts while it does not hold
};

/// Why a condition cannot hold whatever happens, as a problem is told.
struct Impossibility {
    std::string message;
    std::string expected; ///< what could stand there instead
};

/// A kind of condition. Has no data of its own but its key: what a file states is in the Condition, what a
/// running condition remembers in its ConditionState.
class ConditionKind {
public:
    explicit constexpr ConditionKind(std::string_view key) : key_(key) {}
    virtual ~ConditionKind() = default;
    ConditionKind(ConditionKind const&) = delete;
    ConditionKind& operator=(ConditionKind const&) = delete;

    /// The key under which a condition of this kind stands in a level file.
    [[nodiscard]] std::string_view key() const { return key_; }

    // In a file.

    /// Reads what stands under the key. Complains through `body`, with its place, about whatever is wrong.
    virtual void read(JsonNode const& body, Condition& condition, GoalReader& reader) const = 0;
    /// The JSON Schema of what stands under the key.
    [[nodiscard]] virtual nlohmann::ordered_json schema() const = 0;
    /// Why such a condition can never hold in its level, whatever happens; nothing if it may. Its children
    /// are asked for themselves.
    [[nodiscard]] virtual std::optional<Impossibility> whyNever(Condition const& condition,
                                                                CandidateFinder const& candidates) const;

    // At work on a world.

    /// Sets up the state of a condition whose subjects and objects have been found, before the first frame:
    /// complains if they lack what the condition needs, and makes the state's memory. Adds the children,
    /// unless a kind does so in its own way. `it` stands for "it" in them.
    virtual void begin(ConditionState& state, ObjectFinder const& finder, ObjectId it) const;
    /// Looks at the world after a part of a frame; the children have been updated already.
    [[nodiscard]] virtual Standing judge(ConditionState& state, World const& world) const = 0;
    /// Adds the events that make it hold, or not hold if `truth` is false; events that are none may be among
    /// them. Unless a kind does so in its own way: the causes of the children that are as the condition is.
    virtual void collectCauses(ConditionState const& state, World const& world, bool truth,
                               std::vector<EventId>& events) const;

    // To the player.

    /// Whether its children are goals of their own to the player.
    [[nodiscard]] virtual bool listsGoals() const { return false; }
    /// How the child of that number stands as a goal of its own.
    [[nodiscard]] virtual Standing standingOf(ConditionState const& state, std::size_t child) const;
    /// The condition in words, without the time for which it must hold: "keep the lamp lit". `it` is what
    /// "it" is called, null outside a count.
    [[nodiscard]] virtual std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                             Noun const* it) const = 0;
    /// The same with the time for which it must hold, such as " for 3 seconds".
    [[nodiscard]] virtual std::string lastingPhrase(Condition const& condition, GoalWords const& words,
                                                    Noun const* it, std::string const& duration) const;
    /// Whether the phrase is made of several, so that in a list it needs more than commas around it.
    [[nodiscard]] virtual bool isCompound(Condition const& condition) const;

private:
    std::string_view key_;
};

} // namespace trembler
