// Keeps Chipmunk's messages off the terminal, and reports its failed assertions to the caller instead of
// aborting; see failIfGuarded().
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
    // Debian's library prints on standard output that assertions are enabled, at the first space of a
    // process: this output is redirected to a stream that discards it. Needs no file descriptor, as there may
    // be none left.
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

// Chipmunk calls this before it aborts; this definition replaces the library's, which prints.
extern "C" __attribute__((visibility("default"))) void cpMessage(char const* condition, char const* file,
                                                                 int line, int isError, int /*isHardError*/,
                                                                 char const* message, ...) {
    if (isError == 0) {
        return; // a warning, for developers at most
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
