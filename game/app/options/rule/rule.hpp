// What an option accepts. Every option of every command states it, so that all of them refuse wrong values by
// one rule, before any work, and in one form: "--frames 010: expected a whole number from 1 to 10000000".
//
//     accepts(command, command.add_option("--at", at, "..."), "a time in seconds", [](std::string const&
//     text) {
//         return isTime(text) ? fine : wrong();
//     });
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace trembler {

/// What is wrong with a value, in words that follow it; empty words if what was expected says all.
using Fault = std::optional<std::string>;
/// Judges one value of an option, which is not empty. Must not throw.
using Rule = std::function<Fault(std::string const& value)>;

/// States what the option accepts: `expected` in words that follow "expected", and a rule, if not every text
/// is right. The rule is applied after all options are parsed, so it may look at those of the command.
CLI::Option* accepts(CLI::Option* option, std::string const& expected, Rule rule = {});

/// The options whose values are "KEY=VALUE": each key may be stated once. Use it besides accepts().
CLI::Option* oncePerKey(CLI::Option* option);
/// The options whose values are files or folders: each may be stated once, however its path is spelled.
CLI::Option* oncePerPath(CLI::Option* option);

/// What is wrong with the options that a command line states for this command, the first fault in the order
/// in which the command lists its options: a flag, or an option with one value, that is stated twice; the
/// same value twice in a list; an empty value; a value that the option's rule refuses. For people, one line.
[[nodiscard]] std::optional<std::string> faultIn(CLI::App& command);

/// "a whole number from 1 to 100", as accepts() was told; empty if it was told nothing.
[[nodiscard]] std::string expectedBy(CLI::Option& option);

/// A value as messages show it: in one line, and cut off if it is very long.
[[nodiscard]] std::string shown(std::string_view value);

} // namespace trembler
