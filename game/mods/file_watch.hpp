// Notices that files were saved.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// Looks at files on request; it has no clock and no thread. A file counts as saved when two looks in
/// a row find it the same after a change, so that a file is not read while an editor writes it. The
/// content is compared: a file that is only touched, or saved as it was, has not changed. Not
/// thread-safe.
class FileWatch {
public:
    struct Change {
        std::size_t file = 0; ///< its place in the list
        std::optional<std::string>
            text; ///< its present contents; nothing: it does not exist or cannot be read
    };

    /// Changes count from the present contents of the files. Of longer files than `mostBytes` only so many
    /// bytes and one more are read.
    FileWatch(std::vector<std::filesystem::path> files, std::size_t mostBytes);

    /// The changes that were completed since the last look, in the order of the list.
    [[nodiscard]] std::vector<Change> look();

private:
    /// By which a change is noticed without reading the file. An editor that saves by renaming makes another
    /// file, with another time.
    struct Stamp {
        bool there = false;
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;
        friend bool operator==(Stamp const&, Stamp const&) = default;
    };
    struct File {
        std::filesystem::path path;
        Stamp stamp;
        std::optional<std::string> text; // as last reported
        bool changing = false;           // the stamp is new since the last look
    };
    [[nodiscard]] static Stamp stampOf(std::filesystem::path const& path);
    [[nodiscard]] std::optional<std::string> textOf(std::filesystem::path const& path) const;

    std::size_t mostBytes_;
    std::vector<File> files_;
};

} // namespace trembler
