// The folder in which the program keeps what belongs to the player.
#pragma once

#include <filesystem>

namespace trembler {

/// $XDG_DATA_HOME/trembler, or ~/.local/share/trembler if that variable is not set; empty if $HOME is not set
/// either. It need not exist.
[[nodiscard]] std::filesystem::path dataFolder();
/// A file or folder in it; empty if there is no such folder.
[[nodiscard]] std::filesystem::path inDataFolder(std::filesystem::path const& name);

} // namespace trembler
