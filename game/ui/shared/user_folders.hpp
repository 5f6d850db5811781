// Folders of the player's desktop.
#pragma once

#include <filesystem>
#include <string_view>

namespace trembler::ui {

/// Where the player keeps pictures, in a folder of the program's own: as the desktop states it
/// (XDG_PICTURES_DIR in ~/.config/user-dirs.dirs), else ~/Pictures; without a home the current folder. It
/// need not exist.
[[nodiscard]] std::filesystem::path usualPicturesFolder();

/// The folder that the text of a user-dirs.dirs states for pictures; empty if it states none, or the home
/// itself.
[[nodiscard]] std::filesystem::path picturesFolderIn(std::string_view text,
                                                     std::filesystem::path const& home);

} // namespace trembler::ui
