// Reads part definitions.
#pragma once

#include "runtime/level/model/part_library.hpp"
#include "runtime/level/read/folder_limits.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace trembler {

/// Reads one part definition. Throws InputError. Whether the parts of its pieces exist is checked by
/// checkComposites().
[[nodiscard]] PartDefinition readPart(Registry const& registry,
                                      std::shared_ptr<JsonDocument const> const& document);

/// How much a folder of parts may hold.
struct PartLimits {
    std::size_t files = limits::partFiles;
    std::uintmax_t bytes = limits::partBytes; ///< of all files together
    std::uintmax_t before = 0; ///< bytes of other folders of the same level, which count as well
};
/// The *.json files of a folder. Adds a fault if it cannot be read or holds more than it may; of too many
/// files the first by name are returned, of too many bytes none.
[[nodiscard]] std::vector<std::filesystem::path>
partFiles(std::filesystem::path const& folder, std::vector<Diagnostic>& faults, PartLimits const& most = {});
/// Reads every *.json file of a folder. Throws InputError with the problems of all files, also if it holds
/// more than it may.
[[nodiscard]] PartLibrary loadParts(Registry const& registry, std::filesystem::path const& folder,
                                    PartLimits const& most = {});

} // namespace trembler
