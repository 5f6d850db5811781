// The player's progress in each level: whether it is solved, and by which kinds of solutions.
#pragma once

#include "puzzle/campaign/solution_kind.hpp"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <string>
#include <vector>

namespace trembler {

/// Of one level.
struct LevelProgress {
    bool solved = false;
    std::vector<SolutionKind> kinds; ///< found so far, in the order in which they were found

    /// 0: not solved; 1: solved; one more for each other kind of solution, 3 at most.
    [[nodiscard]] int stars() const;
};

/// The most stars that a level can have, and how many of them are shown before they are reached: every level
/// has solutions of two kinds at least.
inline constexpr int mostStars = 3;
inline constexpr int shownStars = 2;

/// Of all levels, by their ids. Plain data; not thread-safe.
class CampaignProgress {
public:
    /// That of a level without any is empty.
    [[nodiscard]] LevelProgress const& of(std::string const& levelId) const;
    /// Returns true if the level was not marked before.
    bool markSolved(std::string const& levelId);
    /// Notes the kind of a run that solved the level. Returns true if it differs from all found before.
    bool addKind(std::string const& levelId, SolutionKind kind);
    /// Adds what another program has noted. No level has fewer stars afterwards than it had in either.
    void add(CampaignProgress const& other);
    /// Forgets everything.
    void clear() { levels_.clear(); }
    [[nodiscard]] bool empty() const { return levels_.empty(); }

    /// {"LEVEL": {"kinds": [{"parts": [..], "actions": [..], "causes": [..]}]}} of the solved levels.
    [[nodiscard]] nlohmann::ordered_json written() const;
    /// The same with what `present`, such a text, has besides: entries and members that this version does not
    /// know, as a newer one may have written them, and entries that it does not understand.
    [[nodiscard]] nlohmann::ordered_json writtenInto(nlohmann::ordered_json present) const;
    /// Adds the entries of a text that written() has made. Ignores entries that are damaged: they must not
    /// affect the others. Returns the ids of their levels, as the text states them.
    std::vector<std::string> read(nlohmann::ordered_json const& stated);

private:
    std::map<std::string, LevelProgress> levels_;
};

} // namespace trembler
