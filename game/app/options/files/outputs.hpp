// The files that a command reads and writes: one convention for all commands about which option may name
// which file.
//
// - An output option takes a file's name; "-" is the terminal (standard output). Where the name may be left
//   out (addOptionalFile), a missing name means "-". An option for a folder takes no "-".
// - If an output goes to the terminal, messages for people go to standard error, or are left out if the
//   output takes their place, as --json does. An output to a file leaves the messages as they are.
// - The option states what kind of file it is (file_kinds.hpp): a name with another ending is refused.
// - An empty name, a file that cannot be written or is also an input, and two outputs to one file are refused
//   before any work.
// - A file is written beside its target and put in its place at the end (runtime/file/output_file.hpp).
//
//     Outputs outputs;
//     outputs.reads(arguments.level);
//     OutputFile* const csv = outputs.add("--csv", arguments.csv); // nullptr: option not given
//     ... if (csv != nullptr) { csv->stream() << ...; }
//     outputs.words() << "a report for people\n";
//     outputs.finish();                                            // throws if anything was not written
#pragma once

#include "game/app/options/files/file_kinds.hpp"
#include "runtime/file/output_file.hpp"

#include <CLI/CLI.hpp>

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// The target of an output option; nullopt: the option was not given.
using OutputTarget = std::optional<std::string>;

/// An option that takes the name of a file of that kind, or "-".
CLI::Option* addFile(CLI::App& command, std::string const& option, OutputTarget& target, FileKind const& kind,
                     std::string const& meaning);
/// An option whose file name may be left out and then means the terminal.
CLI::Option* addOptionalFile(CLI::App& command, std::string const& option, OutputTarget& target,
                             FileKind const& kind, std::string const& meaning);

/// The sentence about outputs in every command's --help.
inline constexpr char const* outputConvention = "FILE can be \"-\": the terminal (standard output). Words "
                                                "for people then go to standard error, or are left "
                                                "out if the option replaces them; with any other FILE they "
                                                "are printed as usual. A file is complete or, if "
                                                "anything fails, as it was before.";

/// After an option whose FILE may be left out, the parser takes a command's own argument for that FILE:
/// "--json LEVEL". Moves it back to the argument of that name and its target if that is empty. Throws
/// CLI::RequiredError if the argument is missing altogether.
void takeBack(CLI::App& command, std::string const& name, std::string& argument, std::string const& option,
              OutputTarget& target);
/// The same for arguments of which there may be none.
void takeBack(CLI::App& command, std::string const& name, std::vector<std::string>& arguments,
              std::string const& option, OutputTarget& target);

class Outputs {
public:
    /// Registers an input file of the command, whether it exists or not. Call before any add().
    void reads(std::filesystem::path const& file);
    /// Opens an output; nullptr if the option was not stated. Throws OutputError, naming the option, if its
    /// file is an input or another output, or cannot be written.
    OutputFile* add(std::string const& option, OutputTarget const& target,
                    OutputFile::Content content = OutputFile::Content::text);
    /// The same checks for an output that other code opens and writes. It cannot go to the terminal:
    /// `expected` is the kind of file that the message asks for instead.
    void claimFile(std::string const& option, OutputTarget const& target, std::string const& expected);
    /// Whether a new file can have this name without anything being replaced: no file, link or folder has it,
    /// and it is neither an input nor another output of the command, even one that is not written yet.
    [[nodiscard]] bool isFree(std::filesystem::path const& name) const;
    /// Leaves the target of an output as it was, and does not write it.
    void drop(OutputFile const& output);
    /// Whether any output goes to the terminal.
    [[nodiscard]] bool terminalTaken() const { return terminalTaken_; }
    /// The stream for messages to people that no output replaces: standard error if an output goes to the
    /// terminal, else standard output.
    [[nodiscard]] std::ostream& words() const;
    /// Throws OutputError, naming the option, if a write has failed so far.
    void check();
    /// Puts all files in place, in the order of add(). Throws OutputError, naming the option, at the first
    /// that fails; the remaining files are not written.
    void finish();

private:
    struct Claim {
        std::string what; ///< "--trace FILE" or "an input"
        std::filesystem::path path;
        std::unique_ptr<OutputFile> file;
    };

    /// Throws OutputError if the target is an input or another output; `expected` states a right name.
    void claim(std::string const& option, std::string const& target, std::string const& expected);

    std::vector<Claim> inputs_;
    std::vector<Claim> outputs_;
    bool terminalTaken_ = false;
};

} // namespace trembler
