// The solutions that the player has saved: a file for each, in a folder for each level.
#pragma once

#include "puzzle/campaign/kept_builds.hpp"
#include "runtime/file/kept_file.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/model/level.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace trembler::ui {

/// A file that `trembler run LEVEL --solution FILE` plays, too.
struct SavedSolution {
    std::filesystem::path file;
    std::string name; ///< as the file states it
};

/// Not thread-safe.
class SavedSolutions {
public:
    /// `folder` is made when the first solution is saved.
    explicit SavedSolutions(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Those of a level, in the order in which they were saved. Files that are none are left out;
    /// damaged ones are moved aside, and the last good ones taken.
    [[nodiscard]] std::vector<SavedSolution> of(std::string const& levelId) const;
    /// Writes a new file and returns its path. Throws OutputError.
    [[nodiscard]] std::filesystem::path save(std::string const& levelId, Solution const& solution) const;
    /// The same, unless one of the level's files says the same already: then nothing is written, and its path
    /// is returned.
    [[nodiscard]] std::filesystem::path keep(std::string const& levelId, Solution const& solution) const;
    /// Gives a solution another name; its file keeps its own. One that was removed meanwhile stays so. Throws
    /// OutputError, also if the file can no longer be read.
    static void rename(SavedSolution const& saved, std::string const& name);
    /// Throws OutputError.
    static void remove(SavedSolution const& saved);
    /// The damaged files that of() has found since the last call.
    [[nodiscard]] std::vector<DamagedFile> takeDamaged() { return std::exchange(damaged_, {}); }
    /// The same of files that could not be read; each once for as long as the program runs.
    [[nodiscard]] std::vector<InputError> takeNotRead() { return std::exchange(notRead_, {}); }

private:
    [[nodiscard]] std::filesystem::path folderOf(std::string const& levelId) const;

    std::filesystem::path folder_;
    mutable std::vector<DamagedFile> damaged_;
    mutable std::vector<InputError> notRead_;
    mutable std::set<std::filesystem::path> told_; // of those
};

} // namespace trembler::ui
