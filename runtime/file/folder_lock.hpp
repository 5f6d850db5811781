// A lock on a folder for the moment in which a program changes files in it that others may change, too.
#pragma once

#include <filesystem>

namespace trembler {

/// Held while it lives; it ends with the program, too, however that ends. The folder itself is locked
/// (flock), so there is no file that could be left behind. Where a file system has no locks, nothing is
/// locked. A thread must not lock a folder twice.
class FolderLock {
public:
    /// Waits up to 0.1 s, as a window must not stand still for a program that was halted. Throws OutputError
    /// with EWOULDBLOCK if another program or thread still holds it then. A folder that does not exist or
    /// cannot be opened is not locked: writing there fails by itself.
    explicit FolderLock(std::filesystem::path const& folder);
    ~FolderLock();
    FolderLock(FolderLock const&) = delete;
    FolderLock& operator=(FolderLock const&) = delete;

private:
    int descriptor_ = -1;
};

} // namespace trembler
