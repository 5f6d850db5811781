// One level of `trembler solve`: the search for its solutions, and placing at random in comparison.
#pragma once

#include "game/app/search/kept_in_level.hpp"
#include "game/app/search/solve_arguments.hpp"
#include "insight/search/search.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

struct SearchedLevel {
    std::filesystem::path file;
    std::string name;
    insight::SearchResult search;
    std::optional<insight::SearchResult> chance; ///< placed at random in as many runs
    bool complete = true;                        ///< false: it was stopped
    /// s that the search took; nothing if some of its runs were done earlier (`--resume`), and how long they
    /// took is not known.
    std::optional<double> seconds;

    /// Nothing if the seconds are not known.
    [[nodiscard]] std::optional<double> runsPerSecond() const;
};

/// Searches, in all members of a team. `many`: it is one of several levels; its progress is reported with its
/// name, and how long it took is written into the journal, for a later search that continues it.
[[nodiscard]] SearchedLevel searchLevel(insight::LevelUnderTest const& level,
                                        std::filesystem::path const& file, SolveArguments const& arguments,
                                        std::uint64_t runs, bool many, WorkPlace& place);

/// The report on a level.
struct LevelSummary {
    nlohmann::ordered_json json;
    std::vector<std::string> lines; ///< for people, one for each kind of solution
};
/// In the leader only. Writes the solutions that were found, if that is requested, in files that replace
/// none, and none of `outputs`, and adds those of kinds that nobody recorded to the level's file, unless
/// `inLevel` is nullptr. Throws OutputError.
[[nodiscard]] LevelSummary summaryOf(SearchedLevel const& searched, insight::LevelUnderTest const& level,
                                     SolveArguments const& arguments, Outputs const& outputs,
                                     KeptInLevel* inLevel, WorkPlace& place);

/// "117 of 200 runs solve it, the first one run 5; 2 kinds of solutions"
[[nodiscard]] std::string countsInWords(insight::SearchResult const& result);

} // namespace trembler
