#include "runtime/file/file_calls.hpp"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trembler {
namespace {

std::atomic<FileCalls*>& callsInUse() {
    static FileCalls system;
    static std::atomic<FileCalls*> inUse{&system};
    return inUse;
}

} // namespace

int FileCalls::open(char const* path, int flags, ::mode_t mode) {
    return ::open(path, flags, mode);
}
::ssize_t FileCalls::write(int descriptor, void const* bytes, std::size_t count) {
    return ::write(descriptor, bytes, count);
}
int FileCalls::fsync(int descriptor) {
    return ::fsync(descriptor);
}
int FileCalls::fchmod(int descriptor, ::mode_t mode) {
    return ::fchmod(descriptor, mode);
}
int FileCalls::close(int descriptor) {
    return ::close(descriptor);
}
int FileCalls::flock(int descriptor, int operation) {
    return ::flock(descriptor, operation);
}
int FileCalls::link(char const* from, char const* to) {
    return ::linkat(AT_FDCWD, from, AT_FDCWD, to, AT_SYMLINK_FOLLOW);
}
int FileCalls::rename(char const* from, char const* to) {
    return ::rename(from, to);
}
int FileCalls::renameNew(char const* from, char const* to) {
#ifdef RENAME_NOREPLACE
    return ::renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE);
#else
    errno = ENOSYS;
    return -1;
#endif
}
int FileCalls::unlink(char const* path) {
    return ::unlink(path);
}
int FileCalls::mkdir(char const* path, ::mode_t mode) {
    return ::mkdir(path, mode);
}

FileCalls& fileCalls() {
    return *callsInUse().load();
}

FileCallsReplaced::FileCallsReplaced(FileCalls& calls) : former_(callsInUse().exchange(&calls)) {}

FileCallsReplaced::~FileCallsReplaced() {
    callsInUse() = former_;
}

} // namespace trembler
