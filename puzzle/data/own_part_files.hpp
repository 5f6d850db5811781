// The player's own parts: files of a folder, of which each may be wrong without harm to the others.
#pragma once

#include "runtime/file/kept_file.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/level/read/read_part.hpp"
#include "runtime/world/registry.hpp"

#include <filesystem>
#include <vector>

namespace trembler {

inline constexpr PartLimits ownPartLimits{.files = 500, .bytes = limits::partBytes};

/// Adds the parts of a folder that can be used, in the order of their files; they may consist of others, and
/// of one another. Returns the faults of the others, among them a name that another part has, with both
/// files; and what the folder holds beyond `most`. It is no fault if there is no such folder. Of a damaged
/// file the last good version is taken; it stays where it is, and `damaged`, if there is one, gets an entry
/// for it.
[[nodiscard]] std::vector<Diagnostic> addOwnParts(Registry const& registry,
                                                  std::filesystem::path const& folder, PartLibrary& library,
                                                  PartLimits const& most = ownPartLimits,
                                                  std::vector<DamagedFile>* damaged = nullptr);

} // namespace trembler
