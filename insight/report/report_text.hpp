// A report on levels as JSON, as Markdown and in words.
#pragma once

#include "insight/report/level_report.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace trembler::insight {

/// One level; other programs rely on its keys, see docs/solving.md.
[[nodiscard]] nlohmann::ordered_json toJson(LevelReport const& report);
/// One found solution: kind, parts, deeds, effects, when it was found, and the solution itself.
[[nodiscard]] nlohmann::ordered_json toJson(FoundSolution const& found);

/// A goal's sentence in English, by its id.
[[nodiscard]] std::string goalText(LevelReport const& report, std::string const& id);

/// One table: a row for each level, with its shortcomings. Like toMarkdown() without times, so that it is the
/// same on every machine.
[[nodiscard]] std::string toMarkdownTable(std::vector<LevelReport> const& reports);
/// That table and a section for each level: the needs of its solutions, the places where parts may lie, and
/// the solutions found.
[[nodiscard]] std::string toMarkdown(std::vector<LevelReport> const& reports);
/// The sections alone.
[[nodiscard]] std::string toMarkdownSections(std::vector<LevelReport> const& reports);
/// A table with a row for each displaced solution and each dropped part: the frame in which each run solved
/// the level; "–" and the last frame of a run that did not.
[[nodiscard]] std::string toMarkdownRuns(std::vector<LevelReport> const& reports);

/// For the terminal, a few lines for each level.
[[nodiscard]] std::string toWords(LevelReport const& report);

} // namespace trembler::insight
