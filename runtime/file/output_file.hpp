// A file that is written completely or not at all. The program writes all files with it.
//
//     OutputFile file("report.json");         // throws at once if it can never be written
//     file.stream() << ...;
//     file.commit();                          // throws if any of it was not written; puts it in place
//
// Commands use it through game/app/options/files/outputs.hpp, which also refuses to overwrite their inputs.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace trembler {

/// Thrown with "FILE: cannot be written: REASON", the reason in the system's words.
class OutputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    /// `error` is an errno.
    OutputError(std::filesystem::path file, int error);
    /// With another message.
    OutputError(std::string const& message, std::filesystem::path file, int error)
        : std::runtime_error(message), file_(std::move(file)), error_(error) {}

    /// The errno of the failure; 0 if it was none of the system's.
    [[nodiscard]] int error() const { return error_; }
    /// What could not be written; empty if the message alone says it.
    [[nodiscard]] std::filesystem::path const& file() const { return file_; }

private:
    std::filesystem::path file_;
    int error_ = 0;
};

/// The file is written without a name in the target's folder (or, if the file system does not support that,
/// with a temporary name, see unfinished_file.hpp), and replaces the target when it is complete. Until then,
/// and if the program fails or is killed, the target stays as it was. If the target is a link, it is
/// followed. The target's permissions are kept; a target without write permission is not replaced. A target
/// that is no regular file, such as a pipe or /dev/null, is written directly, and so is standard output,
/// which has the name "-". One thread at a time.
class OutputFile {
public:
    enum class Content {
        text,   ///< control characters are made visible on standard output
        binary, ///< byte for byte, on standard output, too
    };
    /// Throws OutputError if the name is empty or the file cannot be written there.
    explicit OutputFile(std::filesystem::path target, Content content = Content::text);
    /// A file that gets its name from commitNew(), in a folder that exists. Throws OutputError.
    [[nodiscard]] static OutputFile newIn(std::filesystem::path folder, Content content = Content::text) {
        return {InFolder{}, std::move(folder), content};
    }
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
    /// Writes the rest of the buffer and synchronises the file with its storage; nothing may be written
    /// afterwards. The target stays as it was. Throws OutputError.
    void synchronise();
    /// The same, puts the file in its place and synchronises its folder, so that a loss of power leaves the
    /// former file or this one. Throws OutputError; then the target is as it was, unless it was the folder
    /// that could not be synchronised.
    void commit();
    /// Like commit(), but replaces nothing: the file gets the first of the names name(1), name(2) ... that no
    /// other has, also while other programs do the same. Returns its path. Only for files made by newIn().
    [[nodiscard]] std::filesystem::path commitNew(std::function<std::string(int)> const& name);

private:
    class Stream;
    struct InFolder {};

    OutputFile(InFolder, std::filesystem::path folder, Content content);
    void openBeside();
    void openNamed();
    void giveName();
    void copyUnderName();
    void closeDescriptor();
    void putInPlace();
    [[nodiscard]] bool putAt(std::filesystem::path const& place);
    [[nodiscard]] bool replaceReserved(std::filesystem::path const& place);
    [[noreturn]] void refuse(int error) const;

    std::filesystem::path target_;
    std::filesystem::path place_; // with links followed; empty: written directly
    std::filesystem::path named_; // its temporary name, if it has one
    int descriptor_ = -1;
    int error_ = 0;
    bool synchronised_ = false;
    std::unique_ptr<Stream> stream_;
    Content content_;
};

/// The path that a name refers to when all links are followed, whether the file exists or not.
[[nodiscard]] std::filesystem::path fileBehind(std::filesystem::path path);

/// Writes a whole file. Throws OutputError.
void writeFile(std::filesystem::path const& target, std::string_view bytes,
               OutputFile::Content content = OutputFile::Content::text);

/// Writes a whole file that did not exist, which gets the first of the names name(1), name(2) ... that is
/// free in `folder`. Makes the folder. Returns the file's path. Throws OutputError.
[[nodiscard]] std::filesystem::path writeNewFile(std::filesystem::path const& folder,
                                                 std::function<std::string(int)> const& name,
                                                 std::string_view bytes,
                                                 OutputFile::Content content = OutputFile::Content::text);

/// Has the storage know of the names in a folder. Throws OutputError if the storage fails; a file system that
/// has no such operation is no error.
void synchroniseFolder(std::filesystem::path const& folder);

} // namespace trembler
