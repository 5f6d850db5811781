// Every option of every command, as the program itself lists them, with right and wrong values for each.
#pragma once

#include "game/app/program.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace trembler::test {

/// What is wrong with arguments that are refused, or nothing.
struct Wrong {
    std::vector<std::string> arguments; ///< in place of the option's own right ones
    std::string value;                  ///< that the message must show; empty: none
    std::string why;                    ///< for the test's messages
};

struct TestedOption {
    std::vector<std::string> command; ///< "mod", "check"
    std::string name;                 ///< "--frames", "LEVEL"
    bool flag = false;
    bool list = false;
    std::vector<std::string> right{}; ///< a right value, and a second one if there is any
    std::vector<Wrong> wrong{};       ///< by its kind of value
    std::string expected{};           ///< see expectedBy()

    [[nodiscard]] std::string words() const; ///< "trembler mod check MOD"
    /// The arguments of the command with this option stated so, and all that it needs besides.
    [[nodiscard]] std::vector<std::string> stated(std::vector<std::string> const& so) const;
    /// As the option is stated with a value: {"--frames", "5"}, {"LEVEL"}.
    [[nodiscard]] std::vector<std::string> with(std::string const& value) const;

    std::vector<std::string> besides{}; ///< further arguments that the command needs with it
};

/// Files and folders that values name.
struct Places {
    explicit Places(std::filesystem::path const& folder);

    [[nodiscard]] std::string at(std::string const& name) const { return (folder / name).string(); }
    std::filesystem::path folder;
    std::string level;       ///< a level
    std::string otherLevel;  ///< and another one
    std::string belowAFile;  ///< a path that cannot be
    std::string inNoFolder;  ///< in a folder that is missing
    std::string emptyFolder; ///< a folder in which there is nothing
    std::string dangling;    ///< a link to a file in a folder that is missing
    std::string tooLong;     ///< a path of 5,000 characters
};

/// All options of all commands. Fails the test for an option of which it does not know what it takes: then
/// state that in option_table.cpp.
[[nodiscard]] std::vector<TestedOption> allOptions(Places const& places);

} // namespace trembler::test
