#include "physics/dynamics/core/engine_failure.hpp"

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <vector>

namespace trembler {
namespace {

// The target of the jump for a failed check on this thread.
struct Landing {
    std::jmp_buf place{};
    std::array<char, 256> words{};
};

thread_local Landing* landing = nullptr;
thread_local int guards = 0;

} // namespace

FailureGuard::FailureGuard() {
    ++guards;
}

FailureGuard::~FailureGuard() {
    --guards;
}

void failIfGuarded(char const* words) {
    if (landing != nullptr) {
        std::snprintf(landing->words.data(), landing->words.size(), "%s", words);
        std::longjmp(landing->place, 1);
    }
    if (guards > 0) {
        throw EngineFailure(words, false);
    }
}

void guardBox2d(std::function<void()> const& work) {
    Landing here;
    Landing* const outer = landing;
    landing = &here;
    if (setjmp(here.place) != 0) { // NOLINT(cert-err52-cpp): see the declaration
        landing = outer;
        throw EngineFailure(here.words.data(), false);
    }
    try {
        work();
    } catch (...) {
        landing = outer;
        throw;
    }
    landing = outer;
}

void abandon(std::unique_ptr<Abandonable> engine) {
    static std::mutex mutex;
    static auto* const all =
        new std::vector<Abandonable*>; // never freed, but reachable, so no leak is reported
    std::lock_guard const lock(mutex);
    all->push_back(engine.release());
}

} // namespace trembler

// The function that assert() calls in glibc. This definition replaces the C library's in the whole program;
// outside of a guard it does the same.
extern "C" [[noreturn]] __attribute__((visibility("default"))) void
tremblerAssertionFailed(char const* assertion, char const* file, unsigned line,
                        char const* function) asm("__assert_fail");

extern "C" void tremblerAssertionFailed(char const* assertion, char const* file, unsigned line,
                                        char const* function) {
    std::array<char, 256> words{};
    char const* const slash = std::strrchr(file, '/');
    std::snprintf(words.data(), words.size(), "%s:%u: %s", slash == nullptr ? file : slash + 1, line,
                  assertion);
    trembler::failIfGuarded(words.data());
    std::fprintf(stderr, "%s:%u: %s: Assertion `%s' failed.\n", file, line,
                 function == nullptr ? "?" : function, assertion);
    std::abort();
}
