// A file that is written whole or not at all. Everything that the program writes goes through here.
//
//     OutputFile file("report.json");         // throws at once if it can never be written
//     file.stream() << ...;
//     file.commit();                          // throws if any of it was not written; puts it in place
//
// Commands use it by way of game/app/outputs.hpp, which also refuses to overwrite their inputs.
#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>

namespace trembler {

/// Thrown with "FILE: cannot be written: REASON", the reason in the system's words.
class OutputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Written beside its target, in the same folder without a name (or, where the file system cannot do that,
/// under a name of its own), and put in the target's place when it is complete. Until then, and if
/// the program fails or is killed, the target stays as it was. A target that is a link is followed; its
/// permissions are kept; one that may not be written is not replaced. A target that is no regular file, such
/// as a pipe or /dev/null, is written directly, and so is standard output, which has the name "-". One thread
/// at a time.
class OutputFile {
public:
    enum class Content {
        text,   ///< on standard output control characters in it are made visible
        binary, ///< byte for byte, wherever it goes
    };
    /// Throws OutputError if the name is empty or the file cannot be written there.
    explicit OutputFile(std::filesystem::path target, Content content = Content::text);
    /// Without commit() the target stays as it was.
    ~OutputFile();
    OutputFile(OutputFile const&) = delete;
    OutputFile& operator=(OutputFile const&) = delete;

    [[nodiscard]] bool isStandardOutput() const { return target_ == "-"; }
    /// The name that was given.
    [[nodiscard]] std::filesystem::path const& target() const { return target_; }
    /// The stream to write to. Goes bad when a write fails.
    [[nodiscard]] std::ostream& stream();
    /// For libraries that write by themselves, instead of stream(). They must not close it.
    [[nodiscard]] int descriptor() const { return descriptor_; }
    /// Hands over the failure of such a library, an errno, for commit() to report.
    void failed(int error);
    /// Throws OutputError if a write has failed so far, so that a long computation can stop early.
    void check();
    /// Writes the rest of the buffer, has the system store the file and puts it in its place; nothing may be
    /// written after it. Throws OutputError; then the target is as it was.
    void commit();

private:
    class Stream;

    void openBeside();
    void putInPlace();
    [[noreturn]] void refuse(int error) const;

    std::filesystem::path target_;
    std::filesystem::path place_; // with links followed; empty: written directly
    std::filesystem::path named_; // its temporary name, if it has one
    int descriptor_ = -1;
    int error_ = 0;
    std::unique_ptr<Stream> stream_;
    Content content_;
};

/// The file that a name stands for when all links are followed, whether it is there or not.
[[nodiscard]] std::filesystem::path fileBehind(std::filesystem::path path);

/// Writes a whole file. Throws OutputError.
void writeFile(std::filesystem::path const& target, std::string_view bytes,
               OutputFile::Content content = OutputFile::Content::text);

} // namespace trembler
