// The system calls with which files are written, in one place, so that tests can have each of them fail, or
// end the program before it.
#pragma once

#include <cstddef>
#include <string>
#include <sys/types.h>

namespace trembler {

/// Each function is the system call of its name, with its result and errno. Thread-safe.
class FileCalls {
public:
    FileCalls() = default;
    virtual ~FileCalls() = default;
    FileCalls(FileCalls const&) = delete;
    FileCalls& operator=(FileCalls const&) = delete;

    /// Of a file that is to be written or locked.
    virtual int open(char const* path, int flags, ::mode_t mode);
    virtual ::ssize_t write(int descriptor, void const* bytes, std::size_t count);
    virtual int fsync(int descriptor);
    virtual int fchmod(int descriptor, ::mode_t mode);
    virtual int close(int descriptor);
    virtual int flock(int descriptor, int operation);
    /// linkat() that follows links in `from`, which may be the path of a descriptor in /proc.
    virtual int link(char const* from, char const* to);
    virtual int rename(char const* from, char const* to);
    /// renameat2() with RENAME_NOREPLACE: fails with EEXIST if there is a file `to`, and with EINVAL or
    /// ENOSYS where the file system cannot tell.
    virtual int renameNew(char const* from, char const* to);
    virtual int unlink(char const* path);
    virtual int mkdir(char const* path, ::mode_t mode);
};

/// Those that are in use: the system's, unless a test has replaced them.
[[nodiscard]] FileCalls& fileCalls();

/// Puts other calls in the place of the system's while it lives. For tests, one at a time.
class FileCallsReplaced {
public:
    explicit FileCallsReplaced(FileCalls& calls);
    ~FileCallsReplaced();
    FileCallsReplaced(FileCallsReplaced const&) = delete;
    FileCallsReplaced& operator=(FileCallsReplaced const&) = delete;

private:
    FileCalls* former_;
};

} // namespace trembler
