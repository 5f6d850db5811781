// Files that are being written under a temporary name, and what is left of them when a program is killed.
//
// Whoever writes one holds a lock on it (flock) until it has its final name; the system ends the lock with
// the program. So a file of such a name that can be locked belongs to nobody. Numbers of processes would not
// tell: the system uses them again, and programs in containers and on other machines have the same ones.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace trembler {

/// ".trembler-PROCESS-WHAT.part"
[[nodiscard]] std::string unfinishedName(std::string_view what);

/// Locks a file that was just made, for as long as it is open. False if another program is about to remove
/// it, as it was not locked yet: then another name is needed. Where a file system has no locks, nothing is
/// locked, and removeUnfinished() removes nothing.
[[nodiscard]] bool lockUnfinished(int descriptor);

/// A new unfinished file.
struct UnfinishedFile {
    int descriptor = -1; ///< locked, for writing; -1: none could be made, see `error`
    std::filesystem::path path{};
    int error = 0; ///< an errno
};
[[nodiscard]] UnfinishedFile makeUnfinished(std::filesystem::path const& folder);

/// Removes the unfinished files of a folder that nobody writes any more. The folder must be locked, see
/// FolderLock: links with such names are made under its protection, without a lock of their own.
void removeUnfinished(std::filesystem::path const& folder);

} // namespace trembler
