// Makes libraries that abort the program on invalid numbers throw an exception instead.
//
// Debian's builds of Box2D, Chipmunk and ODE check themselves and abort. The reason is nearly always a
// number, in one world, that exceeds the range of their arithmetic. That must not end the program.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace trembler {

/// An engine failed. what() is one line, for a message.
class EngineFailure : public std::runtime_error {
public:
    /// `intact`: the engine itself detected the failure and can be destroyed. If not, a library was
    /// interrupted and must not be used again, not even to free the engine: see abandon().
    explicit EngineFailure(std::string const& what, bool intact = true)
        : std::runtime_error(what), intact_(intact) {}
    [[nodiscard]] bool intact() const { return intact_; }

private:
    bool intact_;
};

/// While one exists on a thread, a failed check of a library on that thread throws EngineFailure (not
/// intact). Without one, the library ends the program.
class FailureGuard {
public:
    FailureGuard();
    ~FailureGuard();
    FailureGuard(FailureGuard const&) = delete;
    FailureGuard& operator=(FailureGuard const&) = delete;
};

/// Calls `work`, in which Box2D runs. Box2D's checks are compiled as if they could not throw, so a failed
/// check is left by a jump: no frame between this function and Box2D's check may own resources. Throws
/// EngineFailure (not intact).
void guardBox2d(std::function<void()> const& work);

/// To be called by the function that a library calls when one of its checks has failed. Throws or jumps if
/// there is a guard; otherwise returns.
void failIfGuarded(char const* words);

/// The base of objects whose destructors must not run after a failure.
class Abandonable {
public:
    Abandonable() = default;
    virtual ~Abandonable() = default;
    Abandonable(Abandonable const&) = delete;
    Abandonable& operator=(Abandonable const&) = delete;
};

/// Keeps an engine, unused, until the program ends. May be called by several threads.
void abandon(std::unique_ptr<Abandonable> engine);

} // namespace trembler
