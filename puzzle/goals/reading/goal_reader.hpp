// Reads the conditions of a level. The kinds of conditions use it to read their selectors and inner
// conditions.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/level/build/piece_names.hpp"
#include "runtime/level/json/json_node.hpp"

#include <set>
#include <string>
#include <unordered_set>
#include <vector>

namespace trembler {

/// Reads the conditions of one level. Problems are added, with their places, to the list of the node
/// (JsonNode).
class GoalReader {
public:
    explicit GoalReader(LevelFile const& level);

    /// A condition of any kind. Its kind is null if the node does not state exactly one, or if the level has
    /// too many conditions.
    [[nodiscard]] Condition condition(JsonNode const& node);
    /// A list of at least one condition.
    [[nodiscard]] std::vector<Condition> conditions(JsonNode const& node);
    /// A condition in which "it" is an object that a surrounding condition counts.
    [[nodiscard]] Condition conditionOnIt(JsonNode const& node);
    /// Whether the condition that is being read is inside a count.
    [[nodiscard]] bool insideCount() const { return insideCount_; }
    /// The name of an object, {"part": name}, or a list of these.
    [[nodiscard]] Selector selector(JsonNode const& node);

private:
    void readExtras(MemberReader& reader, Condition& condition);
    void readSingle(JsonNode const& node, Selector& selector);
    void readPart(JsonNode const& node, Selector& selector);

    std::string keys_;                      // of all kinds, for messages
    std::vector<std::string> objects_;      // names, in the order of the file
    std::unordered_set<std::string> known_; // the same names, for fast look-up
    PieceNames pieces_;
    std::set<std::string> parts_; // from which the level or the player makes objects
    std::set<std::string> ids_;
    std::size_t conditions_ = 0;
    bool insideCount_ = false;
};

} // namespace trembler
