// Chipmunk's messages are kept off the terminal, and its failed checks do not end the program.
#ifdef TREMBLER_HAS_CHIPMUNK
#include "physics/dynamics/engines/chipmunk/chipmunk_engine.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <utility>

namespace trembler {

cpSpace* newSpaceQuietly() {
    // Debian's library says on the standard output that it has its checks on, at the first space of a
    // process: into a stream that leads nowhere. Needs no file descriptor, of which there may be none left.
    static std::once_flag greeted;
    std::call_once(greeted, [] {
        cookie_io_functions_t nowhere{};
        nowhere.write = [](void*, char const*, std::size_t size) { return static_cast<ssize_t>(size); };
        FILE* const sink = fopencookie(nullptr, "w", nowhere);
        if (sink == nullptr) {
            return;
        }
        FILE* const output = std::exchange(stdout, sink);
        cpSpaceFree(cpSpaceNew());
        stdout = output;
        std::fclose(sink);
    });
    return cpSpaceNew();
}

} // namespace trembler

// Chipmunk calls this before it aborts; defined here it stands in for the library's, which prints.
extern "C" __attribute__((visibility("default"))) void cpMessage(char const* condition, char const* file,
                                                                 int line, int isError, int /*isHardError*/,
                                                                 char const* message, ...) {
    if (isError == 0) {
        return; // a warning, at most of use to its authors
    }
    std::array<char, 200> said{};
    va_list arguments;
    va_start(arguments, message);
    std::vsnprintf(said.data(), said.size(), message, arguments);
    va_end(arguments);
    if (char* const end = std::strchr(said.data(), '\n')) {
        *end = 0;
    }
    trembler::failIfGuarded(said.data());
    std::fprintf(stderr, "Chipmunk: %s (%s, %s:%d)\n", said.data(), condition, file, line);
}
#endif
