// Why arguments are refused, in one line for people.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// The first fault of the options of the command that was chosen, see faultIn(), or an empty value behind
/// "--option="; nothing if they are right.
[[nodiscard]] std::optional<std::string> refusalOf(CLI::App& program,
                                                   std::vector<std::string> const& arguments);
/// The same of arguments of which the parser complains; then at least its complaint: an unknown command or
/// option, with the nearest known one, one that is missing, or two that exclude each other.
[[nodiscard]] std::string refusalOf(CLI::App& program, std::vector<std::string> const& arguments,
                                    CLI::ParseError const& error);

} // namespace trembler
