// The objects that a selector can refer to, including parts that the player may place. Used to find goals
// that can never be reached.
#pragma once

#include "puzzle/goals/model/condition.hpp"
#include "runtime/world/world.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace trembler {

/// The objects that one or more selectors can refer to.
struct Candidates {
    std::set<std::string> names;     ///< of objects of the level
    std::set<std::string> fromTools; ///< parts that the player may place
    std::size_t placed = 0;          ///< how many objects of these parts the player may place
    bool it = false;                 ///< whether "it", the object that a count tests, is among them

    [[nodiscard]] std::size_t size() const { return names.size() + placed + (it ? 1 : 0); }
};

/// Finds candidates in a level and its world before the first frame; both must outlive it.
class CandidateFinder {
public:
    CandidateFinder(LevelFile const& level, World const& world);
    /// Adds the candidates of a selector; an object that is already among them counts once.
    void add(Candidates& candidates, Selector const& selector) const;
    [[nodiscard]] Candidates of(Selector const& selector) const;
    /// Whether all objects that the selector can refer to are fixed. False if there are none, if the player
    /// may place some of them, and for "it".
    [[nodiscard]] bool areFixed(Selector const& selector) const;
    [[nodiscard]] World const& world() const { return world_; }

private:
    World const& world_;
    std::map<std::string, std::vector<std::string const*>> byPart_; // names of objects
    std::map<std::string, std::size_t> tools_;                      // by part, how many
};

} // namespace trembler
