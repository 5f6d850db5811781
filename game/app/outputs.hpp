// What a command reads and writes: which options may name which files, in one convention for all commands.
//
// - An output option takes a file's name; "-" is the terminal (standard output). Where the name may be left
// out
//   (addOptionalFile), none means "-".
// - If an output goes to the terminal, words for people go to standard error.
// - An empty name, a file that is also an input, and two outputs to one file are refused before any work.
// - A file is written beside its target and put in its place at the end (runtime/file/output_file.hpp).
//
//     Outputs outputs;
//     outputs.reads(arguments.level);
//     OutputFile* const csv = outputs.add("--csv", arguments.csv); // nullptr: not asked for
//     ... if (csv != nullptr) { csv->stream() << ...; }
//     outputs.words() << "a report for people\n";
//     outputs.finish();                                            // throws if anything was not written
#pragma once

#include "runtime/file/output_file.hpp"

#include <CLI/CLI.hpp>

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// The target of an output option; none: it was not stated.
using OutputTarget = std::optional<std::string>;

/// An option that takes the name of a file, or "-".
CLI::Option* addFile(CLI::App& command, std::string const& option, OutputTarget& target,
                     std::string const& meaning);
/// An option that can stand alone and then means the terminal.
CLI::Option* addOptionalFile(CLI::App& command, std::string const& option, OutputTarget& target,
                             std::string const& meaning);

/// What every command's --help says about it.
inline constexpr char const* outputConvention = "FILE can be \"-\": the terminal (standard output); words "
                                                "for people then go to standard error. A file is "
                                                "complete or, if anything fails, as it was before.";

/// After an option whose FILE may be left out, a command's own argument looks like that FILE: "--json LEVEL".
/// Gives it back if the argument is missing. Throws CLI::RequiredError if there is none to give.
void takeBack(std::string& argument, OutputTarget& target, char const* name);

class Outputs {
public:
    /// An input of the command, whether it is there or not. Before any add().
    void reads(std::filesystem::path const& file);
    /// Opens an output; nullptr if the option was not stated. Throws OutputError, naming the option, if its
    /// file is an input or another output, or cannot be written.
    OutputFile* add(std::string const& option, OutputTarget const& target,
                    OutputFile::Content content = OutputFile::Content::text);
    /// The same for an output that its own code writes: only looks whether it may.
    void claim(std::string const& option, OutputTarget const& target);
    /// Whether an output goes to the terminal.
    [[nodiscard]] bool terminalTaken() const { return terminalTaken_; }
    /// Where words for people go.
    [[nodiscard]] std::ostream& words() const;
    /// Throws OutputError if a write has failed so far.
    void check();
    /// Completes all of them. Throws OutputError, naming the option, for the first that fails; those after it
    /// are not written.
    void finish();

private:
    struct Claim {
        std::string what; ///< "--trace FILE" or "an input"
        std::filesystem::path path;
        std::unique_ptr<OutputFile> file;
    };

    std::vector<Claim> inputs_;
    std::vector<Claim> outputs_;
    bool terminalTaken_ = false;
};

} // namespace trembler
