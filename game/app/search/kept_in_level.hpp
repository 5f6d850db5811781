// Adds the solutions that a search has found to the list of solutions in the level's own file.
#pragma once

#include "insight/search/search.hpp"
#include "puzzle/edit/document/level_document.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace trembler {

/// The level's file while solutions are added to it: everything else in it stays as its author wrote it.
class KeptInLevel {
public:
    /// Opens the file, so that a search that could not keep anything does not begin. Throws OutputError if it
    /// cannot be changed: it has errors, was made by a newer version of the program, or must not be written.
    /// `data` must outlive this.
    KeptInLevel(GameData const& data, std::filesystem::path const& file);

    /// Adds the reduced solution under a name that no other one of the level has, and returns that name. Of a
    /// demonstration, whose task it fulfils, it is expected to reach the goals only if it does.
    std::string add(insight::FoundSolution const& found, std::size_t number);
    /// Writes the file completely or not at all; does nothing if nothing was added. Throws OutputError, also
    /// if another program has changed the file since it was opened.
    void save();

private:
    edit::LevelDocument document_;
};

} // namespace trembler
