// Libraries that abort the program on numbers that make no sense are made to throw an exception instead.
//
// Debian's builds of Box2D, Chipmunk and ODE check themselves and abort. The reason is nearly always a number
// that has left the range of their arithmetic, in one world. That must not end the program.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace trembler {

/// An engine cannot go on. what() is one line, fit for a message.
class EngineFailure : public std::runtime_error {
public:
    /// `intact`: the engine noticed by itself and can be destroyed. If not, a library was stopped in the
    /// middle of its work and must not be used again, not even to be freed: see abandon().
    explicit EngineFailure(std::string const& what, bool intact = true)
        : std::runtime_error(what), intact_(intact) {}
    [[nodiscard]] bool intact() const { return intact_; }

private:
    bool intact_;
};

/// While one lives on a thread, a failed check inside of a library, on that thread, throws EngineFailure (not
/// intact). Without one, the program ends as the library wants it to.
class FailureGuard {
public:
    FailureGuard();
    ~FailureGuard();
    FailureGuard(FailureGuard const&) = delete;
    FailureGuard& operator=(FailureGuard const&) = delete;
};

/// Calls `work`, in which Box2D runs. Its checks are compiled as if they could not throw, so it is left by a
/// jump: nothing between here and Box2D's check may own anything. Throws EngineFailure (not intact).
void guardBox2d(std::function<void()> const& work);

/// For the function that a library calls when one of its own checks has failed: throws, or jumps, where a
/// guard is; otherwise returns.
void failIfGuarded(char const* words);

/// Something whose destructor must not run.
class Abandonable {
public:
    Abandonable() = default;
    virtual ~Abandonable() = default;
    Abandonable(Abandonable const&) = delete;
    Abandonable& operator=(Abandonable const&) = delete;
};

/// Keeps it, unused, until the program ends. May be called by several threads.
void abandon(std::unique_ptr<Abandonable> engine);

} // namespace trembler
