// The commands of the program, one function each. What they do may throw on bad input, see guarded().
#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace trembler {

inline constexpr int exitSolved = 0;
inline constexpr int exitNotSolved = 1;
inline constexpr int exitBadInput = 2;

/// What a command does once all its options are right; returns the exit status.
using Work = std::function<int()>;

/// Adds a command to the program; when it is chosen, `work` becomes what it does.
void addPlayCommand(CLI::App& program, Work& work);
void addEditCommand(CLI::App& program, Work& work);
void addRunCommand(CLI::App& program, Work& work);
void addVerifyCommand(CLI::App& program, Work& work);
void addReportCommand(CLI::App& program, Work& work);
void addSolveCommand(CLI::App& program, Work& work);
void addComponentsCommand(CLI::App& program, Work& work);
void addSchemaCommand(CLI::App& program, Work& work);
void addAccuracyCommand(CLI::App& program, Work& work);
void addScreenshotCommand(CLI::App& program, Work& work);
void addClipCommand(CLI::App& program, Work& work);
void addKeysCommand(CLI::App& program, Work& work);
void addModCommand(CLI::App& program, Work& work);
void addWhyCommand(CLI::App& program, Work& work);

/// Runs a command's work and returns its exit status; prints errors in its input to standard error.
[[nodiscard]] int guarded(std::function<int()> const& work);

} // namespace trembler
