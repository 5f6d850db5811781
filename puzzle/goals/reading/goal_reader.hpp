// What the kinds of conditions need to read themselves: selectors, and conditions inside conditions.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/level/json/json_node.hpp"

#include <set>
#include <string>
#include <unordered_set>
#include <vector>

namespace trembler {

/// Reads the conditions of one level. Problems go to those of the nodes that it is given, with their places.
class GoalReader {
public:
    explicit GoalReader(LevelFile const& level);

    /// A condition of any kind. Its kind is null if the node states none, or one too many for a level.
    [[nodiscard]] Condition condition(JsonNode const& node);
    /// A list of at least one condition.
    [[nodiscard]] std::vector<Condition> conditions(JsonNode const& node);
    /// A condition in which "it" is an object that a surrounding one counts.
    [[nodiscard]] Condition conditionOnIt(JsonNode const& node);
    [[nodiscard]] bool insideCount() const { return insideCount_; }
    /// The name of an object, {"part": name}, or a list of these.
    [[nodiscard]] Selector selector(JsonNode const& node);

private:
    void readExtras(MemberReader& reader, Condition& condition);
    void readSingle(JsonNode const& node, Selector& selector);
    void readPart(JsonNode const& node, Selector& selector);

    std::string keys_; // of all kinds, for people
    std::vector<std::string> objects_;
    std::unordered_set<std::string> known_; // the same, to be asked
    std::set<std::string> parts_;
    std::set<std::string> ids_;
    std::size_t conditions_ = 0;
    bool insideCount_ = false;
};

} // namespace trembler
