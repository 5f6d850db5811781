// The program's command line: all commands, and what a list of arguments asks for.
#pragma once

#include "game/app/commands.hpp"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace trembler {

/// Adds every command to the parser.
void addCommands(CLI::App& program, Work& work);

/// What arguments ask for. Either there is work to do, or the program ends at once with the status and the
/// text: help, or the one line that says what is wrong with the arguments.
struct Request {
    Work work{};
    int status = exitBadInput;
    std::string out{}; ///< for standard output
    std::string err{}; ///< for standard error
};

/// Parses arguments, without the program's own name, and checks all that can be known before the work of the
/// command: writes nothing and runs nothing. Throws nothing but for lack of memory.
[[nodiscard]] Request requestFrom(std::vector<std::string> const& arguments);

} // namespace trembler
