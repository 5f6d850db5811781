// The folder of a file, and making folders, with a message of the program's own if that fails.
#pragma once

#include <filesystem>

namespace trembler {

/// Where a file lies: its path without the name; "." for a name alone.
[[nodiscard]] std::filesystem::path folderOf(std::filesystem::path const& file);

/// Makes the folder and those above it as far as they are missing, and has the storage know of them; an empty
/// path is the current folder. Throws OutputError, with the folder and the reason in the system's words. A
/// folder that is there is fine, whether it can be written or not. Thread-safe.
void makeFolder(std::filesystem::path const& folder);

} // namespace trembler
