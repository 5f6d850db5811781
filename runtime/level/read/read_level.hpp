// Reads a level file.
#pragma once

#include "runtime/level/model/level.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

/// Reads a level by the registry's property descriptions; part definitions are not used yet. Adds all faults
/// to `problems`; the level is then incomplete.
[[nodiscard]] LevelFile readLevel(Registry const& registry,
                                  std::shared_ptr<JsonDocument const> const& document, Problems& problems);
/// The same, but throws InputError if anything is wrong.
[[nodiscard]] LevelFile readLevel(Registry const& registry,
                                  std::shared_ptr<JsonDocument const> const& document);
/// Reads a file. Throws InputError.
[[nodiscard]] LevelFile loadLevel(Registry const& registry, std::filesystem::path const& path);

} // namespace trembler
