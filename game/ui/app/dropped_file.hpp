// The kind of a file that the player dropped onto the window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace trembler::ui {

struct DroppedFile {
    enum class Kind : std::uint8_t { level, solution, neither };
    Kind kind = Kind::neither;
    std::string why; ///< for the player: why it is neither
};

/// Looks at the keys of a JSON file: levels have "version", solutions "placements", "inputs" or "wires". The
/// rest of the file is checked when it is opened. Throws nothing; a file that cannot be read is neither.
[[nodiscard]] DroppedFile lookAtDropped(std::filesystem::path const& file);

} // namespace trembler::ui
