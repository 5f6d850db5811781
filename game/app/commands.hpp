// The commands of the program, one function each. All return the exit status and never throw on bad input.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace trembler {

inline constexpr int exitSolved = 0;
inline constexpr int exitNotSolved = 1;
inline constexpr int exitBadInput = 2;

/// Adds a command to the program; when it is chosen, `result` becomes its exit status.
void addPlayCommand(CLI::App& program, int& result);
void addEditCommand(CLI::App& program, int& result);
void addRunCommand(CLI::App& program, int& result);
void addVerifyCommand(CLI::App& program, int& result);
void addReportCommand(CLI::App& program, int& result);
void addSolveCommand(CLI::App& program, int& result);
void addComponentsCommand(CLI::App& program, int& result);
void addSchemaCommand(CLI::App& program, int& result);
void addAccuracyCommand(CLI::App& program, int& result);
void addScreenshotCommand(CLI::App& program, int& result);
void addClipCommand(CLI::App& program, int& result);
void addKeysCommand(CLI::App& program, int& result);
void addModCommand(CLI::App& program, int& result);
void addWhyCommand(CLI::App& program, int& result);

/// Runs a command's work and returns its exit status; prints errors in its input to standard error.
[[nodiscard]] int guarded(std::function<int()> const& work);

/// Splits "NAME=VALUE" at the last '=', as component titles may contain others. Throws std::invalid_argument
/// that names the option and the expected form.
[[nodiscard]] std::pair<std::string, std::string> assignment(std::string const& text, char const* option,
                                                             char const* form);
/// The values of options "--detail EFFECT=LEVEL"; the last one of each effect counts.
[[nodiscard]] std::map<std::string, std::string> detailOf(std::vector<std::string> const& options);

} // namespace trembler
