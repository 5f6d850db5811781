#include "runtime/file/folder_lock.hpp"

#include "runtime/file/file_calls.hpp"
#include "runtime/file/output_file.hpp"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>

namespace trembler {

FolderLock::FolderLock(std::filesystem::path const& folder)
    : descriptor_(fileCalls().open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC, 0)) {
    constexpr int tries = 20;
    for (int i = 0; descriptor_ >= 0 && fileCalls().flock(descriptor_, LOCK_EX | LOCK_NB) != 0; ++i) {
        if (errno != EWOULDBLOCK && errno != EINTR) {
            return; // no locks here
        }
        if (i == tries) {
            fileCalls().close(descriptor_);
            throw OutputError(folder, EWOULDBLOCK);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) {
        fileCalls().close(descriptor_);
    }
}

} // namespace trembler
