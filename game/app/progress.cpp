#include "game/app/progress.hpp"

#include "runtime/file/visible_text.hpp"

#include <fmt/format.h>

#include <iostream>
#include <unistd.h>

namespace trembler {
namespace {

constexpr std::chrono::milliseconds patience{1000};
constexpr std::chrono::milliseconds pace{500};

} // namespace

Progress::Progress()
    : watched_(isatty(STDERR_FILENO) != 0), next_(std::chrono::steady_clock::now() + patience) {}

void Progress::frames(std::uint64_t done, std::uint64_t of) {
    if (!watched_) {
        return;
    }
    auto const now = std::chrono::steady_clock::now();
    if (done >= of) {
        clear();
    } else if (now >= next_) {
        next_ = now + pace;
        show(fmt::format("{} of {} frames", done, of));
    }
}

void Progress::say(std::string const& words) {
    if (watched_) {
        show(visible(words));
    }
}

void Progress::clear() {
    if (shown_) {
        show("");
        shown_ = false;
    }
}

// Writes to standard error directly, because std::cerr filters carriage returns. Errors are ignored: progress
// is not a result.
void Progress::show(std::string const& words) {
    std::cerr.flush();
    std::string const line = "\r\x1b[K" + words;
    [[maybe_unused]] ssize_t const written = ::write(STDERR_FILENO, line.data(), line.size());
    shown_ = true;
}

} // namespace trembler
