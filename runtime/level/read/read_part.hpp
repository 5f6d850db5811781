// Reads part definitions.
#pragma once

#include "runtime/level/model/part_library.hpp"

#include <filesystem>
#include <memory>

namespace trembler {

/// Reads one part definition. Throws InputError. Whether the parts of its pieces exist is checked by
/// checkComposites().
[[nodiscard]] PartDefinition readPart(Registry const& registry,
                                      std::shared_ptr<JsonDocument const> const& document);
/// Reads every *.json file of a folder. Throws InputError with the problems of all files.
[[nodiscard]] PartLibrary loadParts(Registry const& registry, std::filesystem::path const& folder);

} // namespace trembler
