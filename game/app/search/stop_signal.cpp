#include "game/app/search/stop_signal.hpp"

#include <atomic>

namespace trembler {
namespace {

// A signal handler can reach only objects of static duration.
std::atomic<bool> stopAsked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not lock");

extern "C" void noteStop(int) {
    stopAsked = true;
}

} // namespace

StopSignal::StopSignal() {
    stopAsked = false;
    struct ::sigaction action {};
    action.sa_handler = noteStop;
    action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART; // the second one ends the program
    sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, &interrupt_);
    ::sigaction(SIGTERM, &action, &terminate_);
}

StopSignal::~StopSignal() {
    ::sigaction(SIGINT, &interrupt_, nullptr);
    ::sigaction(SIGTERM, &terminate_, nullptr);
}

bool StopSignal::asked() {
    return stopAsked;
}

} // namespace trembler
