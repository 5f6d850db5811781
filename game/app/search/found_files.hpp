// Keeps the solutions that a search has found: each as a file that `trembler run --solution` takes, and as a
// picture.
#pragma once

#include "game/app/options/files/outputs.hpp"
#include "insight/search/search.hpp"

#include <filesystem>
#include <string>

namespace trembler {

struct KeptFiles {
    std::filesystem::path solution;
    std::filesystem::path picture; ///< of the moment in which it solves the level; empty: none could be drawn
    std::string whyNoPicture;
    std::string otherName; ///< why the files have not the usual name, in words; empty: they have it
};

/// Writes LEVEL-found-NUMBER.json and .png into the folder, which is made if it is missing. If one of these
/// names is not free (a file has it, or it is an input or output of the command), both get the next free one:
/// LEVEL-found-NUMBER-2, -3 ... Throws OutputError if the solution cannot be written; a picture that cannot
/// be drawn, for example by a program without the window, is left out.
[[nodiscard]] KeptFiles keepFound(GameData const& data, std::filesystem::path const& level,
                                  insight::FoundSolution const& found, std::size_t number,
                                  std::filesystem::path const& folder, Outputs const& outputs);

} // namespace trembler
