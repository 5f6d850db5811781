// Shared by the targets that take bytes for a file.
#pragma once

#include "runtime/level/json/json_document.hpp"
#include "runtime/level/model/level.hpp"
#include "tests/support/game_data.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::files {

/// Throws std::logic_error if a problem is reported without a message.
void requireWords(InputError const& error);
/// A folder that only this process uses, for files that are read by their names.
[[nodiscard]] std::filesystem::path ownFolder();
void write(std::filesystem::path const& file, std::string_view bytes);
/// Opens a level, with a solution if one is stated, and runs it; the hash of every frame. Throws InputError,
/// or std::logic_error if a value of the world is not a finite number.
[[nodiscard]] std::vector<std::uint64_t> hashesOf(LevelFile const& level, PartLibrary const& parts,
                                                  Solution const* solution, int frames, int threads);

} // namespace trembler::files
