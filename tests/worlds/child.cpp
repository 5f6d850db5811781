#include "tests/worlds/trial.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trembler::worlds {
namespace {

void limit(decltype(RLIMIT_CPU) what, rlim_t value) {
    rlimit const both{value, value};
    setrlimit(what, &both);
}

void sayAll(int to, std::string const& text) {
    for (std::size_t at = 0; at < text.size();) {
        ssize_t const wrote = write(to, text.data() + at, text.size() - at);
        if (wrote < 0 && errno != EINTR) {
            return;
        }
        at += wrote > 0 ? static_cast<std::size_t>(wrote) : 0;
    }
}

std::string hearAll(int from) {
    std::string text;
    std::array<char, 65536> some{};
    for (;;) {
        ssize_t const got = read(from, some.data(), some.size());
        if (got > 0) {
            text.append(some.data(), static_cast<std::size_t>(got));
        } else if (got == 0 || errno != EINTR) {
            return text;
        }
    }
}

// Sanitizers reserve far more memory than they use.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool limitMemory = false;
#elif defined(__has_feature)
constexpr bool limitMemory = !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool limitMemory = true;
#endif

} // namespace

Ended inChild(std::function<std::string()> const& work, unsigned seconds) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) {
        throw std::runtime_error("no pipe");
    }
    std::FILE* const murmurs = std::tmpfile();
    if (murmurs == nullptr) {
        throw std::runtime_error("no temporary file");
    }
    std::fflush(nullptr);
    pid_t const child = fork();
    if (child < 0) {
        throw std::runtime_error("no child process");
    }
    if (child == 0) {
        close(ends[0]);
        dup2(fileno(murmurs), STDOUT_FILENO);
        dup2(fileno(murmurs), STDERR_FILENO);
        limit(RLIMIT_CPU, seconds);
        limit(RLIMIT_CORE, 0);
        if (limitMemory) {
            limit(RLIMIT_AS, rlim_t{4} << 30U);
        }
        int status = 0;
        try {
            sayAll(ends[1], work());
        } catch (std::exception const& error) {
            std::fprintf(stderr, "threw: %s\n", error.what());
            status = 1;
        }
        std::fflush(nullptr);
        _exit(status);
    }
    close(ends[1]);
    Ended ended;
    ended.said = hearAll(ends[0]);
    close(ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    ended.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    constexpr off_t most = 2000;
    off_t const size = lseek(fileno(murmurs), 0, SEEK_END);
    lseek(fileno(murmurs), size > most ? size - most : 0, SEEK_SET);
    ended.murmured = hearAll(fileno(murmurs));
    std::fclose(murmurs);
    return ended;
}

} // namespace trembler::worlds
