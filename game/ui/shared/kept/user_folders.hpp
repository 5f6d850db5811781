// Folders of the player's desktop.
#pragma once

#include <filesystem>
#include <string_view>

namespace trembler::ui {

/// Where the player keeps pictures, in a folder of the program's own: as the desktop states it
/// (XDG_PICTURES_DIR in ~/.config/user-dirs.dirs), else ~/Pictures; without a home the current folder. It
/// need not exist.
[[nodiscard]] std::filesystem::path usualPicturesFolder();

/// Where files that others send usually arrive: as the desktop states it (XDG_DOWNLOAD_DIR), else
/// ~/Downloads; the home if there is no such folder, and without a home the current folder.
[[nodiscard]] std::filesystem::path usualDownloadsFolder();

/// The folder that the text of a user-dirs.dirs states under that name, such as "XDG_PICTURES_DIR"; empty if
/// it states none, or the home itself.
[[nodiscard]] std::filesystem::path userFolderIn(std::string_view text, std::string_view name,
                                                 std::filesystem::path const& home);

} // namespace trembler::ui
