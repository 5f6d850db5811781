// A file that a player owns: progress, settings, parts, solutions, levels. Everything of that kind is read
// and written here, so that whatever happens a good version remains:
//
// - It is written aside, synchronised and renamed; the version before it is kept as FILE~, the last good one.
// - One that is cut, empty or damaged is moved aside to FILE.damaged-1, never overwritten, and the last good
//   one is taken in its place.
// - Programs that change the same file at the same time do so one after the other, each from what is there
// then.
//
// Files that are only ever written as new ones, such as pictures, are written with writeNewFile() instead.
#pragma once

#include "runtime/file/output_file.hpp"
#include "runtime/level/json/limits.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace trembler {

/// Whether a text is a whole file, not a part of one.
using IsWhole = std::function<bool(std::string_view)>;
/// A JSON object with nothing behind it. Every beginning of one that is cut before its last brace is none.
[[nodiscard]] bool isWholeJson(std::string_view text);

/// A file that was found damaged, or was gone although its last good version is there.
struct DamagedFile {
    std::filesystem::path file;
    std::filesystem::path aside{};      ///< where it is now; empty: it is gone, or still in its place
    std::optional<OutputError> stays{}; ///< why it could not be moved; then nothing is written in its place
    bool gone = false;                  ///< there was no file
    bool lastTaken = false;             ///< the last good version was taken in its place
};

/// What was found of a file.
struct KeptText {
    std::optional<std::string> text;      ///< nothing: there is neither a good file nor a last good one
    std::optional<DamagedFile> damaged{}; ///< nothing: it was good, or there is none

    /// Whether the text is that of the file in its place, not the last good one.
    [[nodiscard]] bool inPlace() const { return text && (!damaged || !damaged->lastTaken); }
};

/// Functions may be called by several threads and programs at once. Paths may be links, which are followed.
class KeptFile {
public:
    /// `most`: its bytes. A larger file is not read, and none is written.
    explicit KeptFile(std::filesystem::path const& file, IsWhole whole = isWholeJson,
                      std::size_t most = limits::fileSize);

    /// Of the file, or of the last good one. A damaged file is moved aside now, if that is possible. Throws
    /// InputError if the file is there and cannot be read: then it is not known to be damaged.
    [[nodiscard]] KeptText read() const;
    /// The same, but a damaged file stays in its place: for whoever only looks at other people's files.
    [[nodiscard]] KeptText look() const;
    /// Replaces the text; makes the folder. Throws OutputError if it cannot be written, or if a damaged file
    /// cannot be moved aside, or what is there cannot be read, or the text is too large (EFBIG); then the
    /// file is as it was.
    void write(std::string_view text) const;
    /// The same with a text that `text` makes of what is there at that moment, while other programs wait; it
    /// may return nothing to leave everything as it is, a damaged file included. Returns what was there.
    /// Passes on what `text` throws.
    KeptText change(std::function<std::optional<std::string>(KeptText const&)> const& text) const;
    /// Removes it and its last good version; none of them need exist. Throws OutputError.
    void remove() const;

    [[nodiscard]] std::filesystem::path const& path() const { return file_; }
    /// FILE~
    [[nodiscard]] std::filesystem::path lastGood() const;

private:
    [[nodiscard]] std::optional<std::string> presentText() const;
    [[nodiscard]] std::optional<std::string> lastText() const;
    [[nodiscard]] std::filesystem::path moveAside() const;
    void keepAsLast(std::string const& present) const;

    std::filesystem::path file_; // with links followed
    IsWhole whole_;
    std::size_t most_;
};

} // namespace trembler
