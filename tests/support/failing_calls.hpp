// A disk that fails, or a program that is killed, at any chosen system call.
#pragma once

#include "runtime/file/file_calls.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <functional>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace trembler::test {

/// Nothing is synchronised: no test cuts the power, and it takes as long as a disk that others use.
class CallsWithoutSync : public FileCalls {
public:
    int fsync(int /*descriptor*/) override { return 0; }
};

/// Counts the calls, from 1, and does something instead of one of them, or of all from one on.
class FailingCalls : public CallsWithoutSync {
public:
    enum class Then { nothing, failOnce, failForEver, kill };

    explicit FailingCalls(Then then = Then::nothing, int at = 0, int error = 0)
        : then_(then), at_(at), error_(error) {}

    [[nodiscard]] int calls() const { return calls_; }
    /// "fsync profile.json", "rename a -> b", with the names of files only, as far as they are known.
    [[nodiscard]] std::vector<std::string> const& log() const { return log_; }
    /// One byte per call of write().
    bool slow = false;
    /// As on a file system without hard links.
    bool linkless = false;

    int open(char const* path, int flags, ::mode_t mode) override {
        return fails("open " + nameOf(path)) ? -1 : FileCalls::open(path, flags, mode);
    }
    ::ssize_t write(int descriptor, void const* bytes, std::size_t count) override {
        return fails("write")
                   ? -1
                   : FileCalls::write(descriptor, bytes, slow ? std::min<std::size_t>(count, 1) : count);
    }
    int fsync(int descriptor) override {
        struct ::stat is {};
        bool const folder = ::fstat(descriptor, &is) == 0 && S_ISDIR(is.st_mode);
        return fails(folder ? "fsync folder" : "fsync file") ? -1 : CallsWithoutSync::fsync(descriptor);
    }
    int fchmod(int descriptor, ::mode_t mode) override {
        return fails("fchmod") ? -1 : FileCalls::fchmod(descriptor, mode);
    }
    int close(int descriptor) override {
        if (fails("close")) {
            FileCalls::close(descriptor); // as the system does: it is closed all the same
            errno = error_;
            return -1;
        }
        return FileCalls::close(descriptor);
    }
    int flock(int descriptor, int operation) override {
        return fails("flock") ? -1 : FileCalls::flock(descriptor, operation);
    }
    int link(char const* from, char const* to) override {
        if (linkless && !std::string_view(from).starts_with("/proc/")) {
            errno = EPERM;
            return -1;
        }
        return fails("link " + nameOf(from) + " -> " + nameOf(to)) ? -1 : FileCalls::link(from, to);
    }
    int rename(char const* from, char const* to) override {
        return fails("rename " + nameOf(from) + " -> " + nameOf(to)) ? -1 : FileCalls::rename(from, to);
    }
    int unlink(char const* path) override {
        return fails("unlink " + nameOf(path)) ? -1 : FileCalls::unlink(path);
    }
    int mkdir(char const* path, ::mode_t mode) override {
        return fails("mkdir " + nameOf(path)) ? -1 : FileCalls::mkdir(path, mode);
    }

private:
    static std::string nameOf(std::string const& path) { return path.substr(path.rfind('/') + 1); }

    bool fails(std::string what) {
        log_.push_back(std::move(what));
        ++calls_;
        bool const now = then_ == Then::failForEver ? calls_ >= at_ : calls_ == at_;
        if (then_ == Then::nothing || !now) {
            return false;
        }
        if (then_ == Then::kill) {
            ::kill(::getpid(), SIGKILL);
        }
        errno = error_;
        return true;
    }

    Then then_;
    int at_;
    int error_;
    int calls_ = 0;
    std::vector<std::string> log_;
};

/// Runs `work` in a process of its own and waits for it. Returns whether it ended by itself, with a result of
/// true; not if it was killed.
inline bool inProcess(std::function<bool()> const& work) {
    ::pid_t const child = ::fork();
    if (child == 0) {
        bool good = false;
        try {
            good = work();
        } catch (...) {
        }
        ::_exit(good ? 0 : 1);
    }
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Runs `work` in processes of their own that are killed (kill -9) before their first, second ... call, and
/// `after` when each is dead, until one gets to its end. Returns how many were killed.
inline int killedAtEachCall(std::function<void()> const& before, std::function<void()> const& work,
                            std::function<void(int)> const& after) {
    for (int at = 1;; ++at) {
        before();
        bool const ended = inProcess([&] {
            FailingCalls calls(FailingCalls::Then::kill, at);
            FileCallsReplaced const replaced(calls);
            work();
            return true;
        });
        after(at);
        if (ended || at > 1000) {
            return at - 1;
        }
    }
}

} // namespace trembler::test
