// Options and arguments that take one of a few words.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace trembler {

/// One of the words, which is stored in `target`; any other is refused with the nearest one.
CLI::Option* addChoice(CLI::App& command, std::string const& option, std::string& target,
                       std::vector<std::string> const& words, std::string const& meaning);

} // namespace trembler
