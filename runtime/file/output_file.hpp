// A file that is written completely or not at all. The program writes all files with it.
//
//     OutputFile file("report.json");         // throws at once if it can never be written
//     file.stream() << ...;
//     file.commit();                          // throws if any of it was not written; puts it in place
//
// Commands use it through game/app/options/outputs.hpp, which also refuses to overwrite their inputs.
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

/// The file is written without a name in the target's folder (or, if the file system does not support that,
/// with a temporary name), and replaces the target when it is complete. Until then, and if the program fails
/// or is killed, the target stays as it was. If the target is a link, it is followed. The target's
/// permissions are kept; a target without write permission is not replaced. A target that is no regular file,
/// such as a pipe or /dev/null, is written directly, and so is standard output, which has the name "-". One
/// thread at a time.
class OutputFile {
public:
    enum class Content {
        text,   ///< control characters are made visible on standard output
        binary, ///< byte for byte, on standard output, too
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
    /// For libraries that write to a descriptor, instead of stream(). They must not close it.
    [[nodiscard]] int descriptor() const { return descriptor_; }
    /// Stores the errno of such a library's failure, for commit() to report.
    void failed(int error);
    /// Throws OutputError if a write has failed so far, so that a long computation can stop early.
    void check();
    /// Writes the rest of the buffer, synchronises the file with its storage and puts it in its place;
    /// nothing may be written afterwards. Throws OutputError; then the target is as it was.
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

/// The path that a name refers to when all links are followed, whether the file exists or not.
[[nodiscard]] std::filesystem::path fileBehind(std::filesystem::path path);

/// Writes a whole file. Throws OutputError.
void writeFile(std::filesystem::path const& target, std::string_view bytes,
               OutputFile::Content content = OutputFile::Content::text);

} // namespace trembler
