#include "game/app/search/solve_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

std::string firstOf(insight::SearchResult const& result) {
    return result.firstSolved ? fmt::format("{}", *result.firstSolved) : "–";
}

/// A name inside a table.
std::string cell(std::string const& name) {
    std::string text;
    for (char const c : name) {
        text += c == '|' ? std::string("\\|") : std::string(1, c);
    }
    return text;
}

bool anyChance(std::vector<SearchedLevel> const& levels) {
    return std::any_of(levels.begin(), levels.end(),
                       [](auto const& level) { return level.chance.has_value(); });
}

} // namespace

std::string solveLine(SearchedLevel const& level) {
    std::string line = fmt::format("{}: {}", level.name, countsInWords(level.search));
    if (level.chance) {
        line += fmt::format("; at random {} of {}", level.chance->solved, level.chance->runs);
    }
    if (auto const speed = level.runsPerSecond()) {
        line += fmt::format("; {:.0f} runs per second", *speed);
    }
    return line + (level.complete ? "" : " (stopped)");
}

std::string solveSummary(std::vector<SearchedLevel> const& levels) {
    auto const solved = std::count_if(levels.begin(), levels.end(),
                                      [](auto const& level) { return level.search.solved > 0; });
    std::string text = fmt::format("Solved by the search: {} of {} level{}", solved, levels.size(),
                                   levels.size() == 1 ? "" : "s");
    if (anyChance(levels)) {
        auto const chance = std::count_if(levels.begin(), levels.end(), [](auto const& level) {
            return level.chance && level.chance->solved > 0;
        });
        text += fmt::format("; at random: {}", chance);
    }
    return text + ".";
}

std::string solveTable(std::vector<SearchedLevel> const& levels) {
    bool const compares = anyChance(levels);
    std::string text = "| level | runs | solved | first run | kinds |";
    std::string line = "|---|---|---|---|---|";
    if (compares) {
        text += " at random: solved | first run |";
        line += "---|---|";
    }
    text += "\n" + line + "\n";
    for (SearchedLevel const& level : levels) {
        text += fmt::format("| {}{} | {} | {} | {} | {} |", cell(level.name),
                            level.complete ? "" : " (stopped)", level.search.runs, level.search.solved,
                            firstOf(level.search), level.search.found.size());
        if (compares && level.chance) {
            text += fmt::format(" {} | {} |", level.chance->solved, firstOf(*level.chance));
        } else if (compares) {
            text += " – | – |";
        }
        text += "\n";
    }
    return text + "\n" + solveSummary(levels) + "\n";
}

} // namespace trembler
