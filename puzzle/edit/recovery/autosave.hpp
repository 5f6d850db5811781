// Keeps unsaved work safe from crashes, in files beside the settings.
#pragma once

#include "puzzle/edit/document/level_document.hpp"
#include "runtime/file/kept_file.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace trembler::edit {

/// The folder for recovery files, beside the profile with the settings: recovery/ in dataFolder(). Empty if
/// there is none: then nothing is kept.
[[nodiscard]] std::filesystem::path recoveryFolder();

/// Writes one document's unsaved text to a recovery file of its own, completely or not at all. The file is
/// removed when the document is saved or closed in order; it stays if the program dies. While the program
/// lives, a lock file prevents other programs from offering it.
class Autosave {
public:
    /// Work older than this is on the disk, s, if tick() is called for every picture.
    static constexpr double interval = 1.0;

    /// Nothing is written before the first change. An empty folder switches it off.
    explicit Autosave(std::filesystem::path folder);
    /// Ends in order, like close().
    ~Autosave();
    Autosave(Autosave const&) = delete;
    Autosave& operator=(Autosave const&) = delete;

    /// `seconds` have passed. Writes the file if the document has changed and the interval is over; removes
    /// it if the document is as it was saved. Never throws: see error().
    void tick(LevelDocument const& document, double seconds);
    /// Writes at once if anything has changed, without regard to the interval: before something risky, such
    /// as a test play.
    void flush(LevelDocument const& document);
    /// Removes the file: the author saved, or does not want the changes.
    void close();
    /// Ends without removing the file, as if the program had been killed. For tests.
    void abandon();
    /// Why the last writing failed; nothing if it did not. tick() tries again after the interval.
    [[nodiscard]] std::optional<OutputError> const& error() const { return error_; }
    /// Of the recovery file; empty before the first one was written.
    [[nodiscard]] std::filesystem::path const& file() const { return file_; }

private:
    void write(LevelDocument const& document);
    void takeLock();

    std::filesystem::path folder_;
    std::filesystem::path file_;
    std::filesystem::path lockFile_;
    int lock_ = -1;
    double since_ = 0;                     // s, since the last writing
    std::optional<std::uint64_t> written_; // the revision in the file
    std::optional<OutputError> error_;
};

/// Work that was left behind by a program that ended without closing it.
struct Recovery {
    std::filesystem::path file;        ///< the recovery file
    std::filesystem::path level;       ///< the level's own file; empty for a new level
    std::string title;                 ///< of the level, for people; may be empty
    std::string text;                  ///< of the level
    std::optional<std::string> onDisk; ///< the text of the level's file when it was opened or saved last
    /// Whether the level's file has changed since: saving the recovered document will be a conflict.
    bool changedSince = false;
};

/// What findRecoveries() reads at most: so many files, and as many bytes together as are still allowed when a
/// file's turn comes, but always one.
struct RecoveryLimits {
    std::size_t files = 1000;
    std::size_t bytes = std::size_t{256} << 20U;
};

/// What was found beside recoveries.
struct RecoveryTroubles {
    std::vector<DamagedFile> damaged;
    std::vector<InputError> notRead; ///< for each file that cannot be read why not
    std::size_t leftOut = 0;         ///< files beyond the limits, which are found when others are gone
};

/// The recoveries of a folder that no living program holds, the newest first. Files that are no recoveries
/// are left out; one whose text is that of the level's file is removed, as nothing would be lost. Throws
/// nothing. Damaged ones are moved aside and their last good versions taken. Adds to `troubles`, if there are
/// any.
[[nodiscard]] std::vector<Recovery> findRecoveries(std::filesystem::path const& folder,
                                                   RecoveryTroubles* troubles = nullptr,
                                                   RecoveryLimits const& most = {});
/// The newest one of a level, among the RecoveryLimits().files newest; of new levels, if `level` is empty.
/// Says in `troubles` what was left out only if it finds none.
[[nodiscard]] std::optional<Recovery> findRecovery(std::filesystem::path const& folder,
                                                   std::filesystem::path const& level,
                                                   RecoveryTroubles* troubles = nullptr);
/// The recovered document, modified and writable, even if it has problems. Throws InputError if its text is
/// not JSON. The recovery file stays until discard(); call it once the document's own Autosave has written.
[[nodiscard]] LevelDocument recover(GameData const& data, Recovery const& recovery);
/// Removes the file, with its lock.
void discard(Recovery const& recovery);

} // namespace trembler::edit
