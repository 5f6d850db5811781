// The interface of a kind of goal condition ("inside", "touching", "all" ...). Each kind is one file in
// conditions/ and one line in the table there; no other code depends on the kind.
#pragma once

#include "runtime/object/object_id.hpp"
#include "runtime/trace/event.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
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
struct WholeLevel;
enum class Mood;
struct Condition;
struct Noun;

/// The present state of a condition.
struct Standing {
    bool holds = false;  ///< at present, whether or not for the required time
    double progress = 0; ///< 0 to 1: how much of it is done; not used while it holds
};

/// Why a condition can never hold, in the words of a message.
struct Impossibility {
    std::string message;
    std::string expected; ///< the accepted values
    std::string path{};   ///< in the file, of the inner condition at fault; empty: the condition itself
};

/// The initial form of a condition that an editor adds.
struct ConditionDraft {
    std::vector<std::string> objects; ///< names, the first for the first selector
    nlohmann::ordered_json area;      ///< as a level file states it, m
};

/// A kind of condition. Has no data but its key: the data of a file are in the Condition, the memory of a
/// running condition in its ConditionState.
class ConditionKind {
public:
    explicit constexpr ConditionKind(std::string_view key) : key_(key) {}
    virtual ~ConditionKind() = default;
    ConditionKind(ConditionKind const&) = delete;
    ConditionKind& operator=(ConditionKind const&) = delete;

    /// The key under which a condition of this kind is stored in a level file.
    [[nodiscard]] std::string_view key() const { return key_; }

    // Reading a condition from a file.

    /// Reads `body`, the value that is stored under the key. Complains through `body`, with its place, about
    /// all faults.
    virtual void read(JsonNode const& body, Condition& condition, GoalReader& reader) const = 0;
    /// The JSON Schema of the value that is stored under the key.
    [[nodiscard]] virtual nlohmann::ordered_json schema() const = 0;
    /// Why such a condition can never hold in its level; nothing if it may hold. Its children are checked
    /// separately.
    [[nodiscard]] virtual std::optional<Impossibility> whyNever(Condition const& condition,
                                                                CandidateFinder const& candidates) const;

    /// Why such a condition can never come true in its level as a whole, although whyNever() finds nothing:
    /// for the checks of finished levels, see complainAboutHopeless(). Empty if it may come true.
    [[nodiscard]] virtual std::vector<Impossibility> whyHopeless(Condition const& condition,
                                                                 WholeLevel const& level) const;

    // Editing a condition. Which members of the value are selectors, areas and conditions is known from
    // schema(), see ConditionOutline.

    /// A value that an editor begins with; `with` has at least draftObjects() objects.
    [[nodiscard]] virtual nlohmann::ordered_json draft(ConditionDraft const& with) const = 0;
    /// How many objects a draft is about at least.
    [[nodiscard]] virtual std::size_t draftObjects() const { return 1; }

    // Judging whether a condition holds in a world.

    /// Sets up the state of a condition whose subjects and objects have been found, before the first frame:
    /// complains if they lack properties that the condition needs, and initialises the state's memory. By
    /// default adds a state for each child. `it` is the object that "it" refers to in the children.
    virtual void begin(ConditionState& state, ObjectFinder const& finder, ObjectId it) const;
    /// Judges the world after a part of a frame; the children have been updated already.
    [[nodiscard]] virtual Standing judge(ConditionState& state, World const& world) const = 0;
    /// Adds the events that make it hold or, if `truth` is false, not hold; empty event ids may be among
    /// them. By default these are the causes of the children that are met or, if `truth` is false, not met.
    virtual void collectCauses(ConditionState const& state, World const& world, bool truth,
                               std::vector<EventId>& events) const;

    /// Whether it holds exactly if all its children are met.
    [[nodiscard]] virtual bool needsAllChildren() const { return false; }

    // Describing a condition to the player.

    /// Whether the player sees its children as separate goals.
    [[nodiscard]] virtual bool listsGoals() const { return false; }
    /// The present state of the child with that index as a separate goal.
    [[nodiscard]] virtual Standing standingOf(ConditionState const& state, std::size_t child) const;
    /// How many equal steps or objects the player sees counted until it is met; 0: it is not counted.
    [[nodiscard]] virtual int countedSteps(Condition const& condition) const;
    /// The condition in words, without the time for which it must hold: "keep the lamp lit". `it` is the noun
    /// for "it", null outside a count.
    [[nodiscard]] virtual std::string phrase(Condition const& condition, GoalWords const& words, Mood mood,
                                             Noun const* it) const = 0;
    /// The same with `duration`, the time for which it must hold, such as " for 3 seconds".
    [[nodiscard]] virtual std::string lastingPhrase(Condition const& condition, GoalWords const& words,
                                                    Noun const* it, std::string const& duration) const;
    /// Whether the phrase is made of several phrases, so that in a list commas do not suffice to separate it.
    [[nodiscard]] virtual bool isCompound(Condition const& condition) const;

private:
    std::string_view key_;
};

} // namespace trembler
