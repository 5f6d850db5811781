#include "runtime/file/unfinished_file.hpp"

#include "runtime/file/file_calls.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace trembler {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view nameBegin = ".trembler-";
constexpr std::string_view nameEnd = ".part";
constexpr unsigned mostNames = 10'000;
constexpr ::mode_t modeOfNewFiles = 0666; // less the umask

/// Whether the path is that of the open file.
bool isAt(fs::path const& path, int descriptor) {
    struct ::stat named {};
    struct ::stat opened {};
    return ::lstat(path.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 &&
           named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

} // namespace

std::string unfinishedName(std::string_view what) {
    return fmt::format("{}{}-{}{}", nameBegin, ::getpid(), what, nameEnd);
}

bool lockUnfinished(int descriptor) {
    if (fileCalls().flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        return errno != EWOULDBLOCK;
    }
    struct ::stat is {};
    return ::fstat(descriptor, &is) != 0 || is.st_nlink > 0;
}

UnfinishedFile makeUnfinished(fs::path const& folder) {
    for (unsigned attempt = 0; attempt < mostNames; ++attempt) {
        fs::path path = folder / unfinishedName(std::to_string(attempt));
        int const descriptor =
            fileCalls().open(path.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, modeOfNewFiles);
        if (descriptor < 0) {
            if (errno != EEXIST) {
                return {.error = errno};
            }
        } else if (lockUnfinished(descriptor)) {
            return {descriptor, std::move(path)};
        } else {
            fileCalls().close(descriptor);
        }
    }
    return {.error = EEXIST};
}

void removeUnfinished(fs::path const& folder) {
    std::error_code error;
    for (fs::directory_iterator at(folder, error), last; !error && at != last; at.increment(error)) {
        std::string const name = at->path().filename().string();
        if (!name.starts_with(nameBegin) || !name.ends_with(nameEnd)) {
            continue;
        }
        // Opened for writing, as file systems on a network lock no other files.
        int const descriptor =
            fileCalls().open(at->path().c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0);
        if (descriptor < 0) {
            continue;
        }
        // While it was opened, its writer may have finished it, and another have taken the name.
        if (fileCalls().flock(descriptor, LOCK_EX | LOCK_NB) == 0 && isAt(at->path(), descriptor)) {
            fileCalls().unlink(at->path().c_str());
        }
        fileCalls().close(descriptor);
    }
}

} // namespace trembler
