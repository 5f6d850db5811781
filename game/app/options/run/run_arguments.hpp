// The arguments of `trembler run`.
#pragma once

#include "game/app/options/files/outputs.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

struct RunArguments {
    std::string level;
    std::string solution; ///< by name or file; empty: none
    std::optional<std::uint64_t> frames;
    int threads = 1;
    std::uint64_t hashEvery = 0; ///< frames between printed hashes; 0: only the last frame's
    std::vector<std::string> detail;
    std::vector<std::string> periods;
    std::optional<int> substeps;
    std::optional<double> budget;    ///< ms
    std::optional<double> slowAfter; ///< s of time on processors; frames that take longer are told
    std::vector<std::string> watch;  ///< OBJECT.FIELD each
    std::vector<std::string> mods;   ///< folders in which mods are looked for
    std::uint64_t every = 1;         ///< frames between rows of the table

    OutputTarget json;
    OutputTarget trace;
    OutputTarget account;
    OutputTarget sound;
    OutputTarget spice;
    OutputTarget record;
    OutputTarget csv;
    OutputTarget svg;
};

/// Runs the level and writes the requested outputs; returns the exit status. Throws InputError, OutputError,
/// std::invalid_argument or std::runtime_error on failure.
[[nodiscard]] int runLevel(RunArguments const& arguments);

} // namespace trembler
