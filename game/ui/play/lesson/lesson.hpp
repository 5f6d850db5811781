// The first lesson of a level: which of its steps is shown to the player at present.
#pragma once

#include "game/ui/shared/commands/named_keys.hpp"
#include "puzzle/session/session.hpp"

#include <SDL_events.h>

#include <cstdint>
#include <span>

namespace trembler::ui {

/// The player's input device, for the words of the lesson.
enum class InputDevice : std::uint8_t { mouse, keys, pad };

/// The device of the last event of a player's; `before` if there is none among them.
[[nodiscard]] InputDevice deviceOf(std::span<SDL_Event const> events, InputDevice before);

/// The device whose keys are named to a player with that one: the mouse has none.
[[nodiscard]] inline KeyDevice keyDevice(InputDevice device) {
    return device == InputDevice::pad ? KeyDevice::pad : KeyDevice::keyboard;
}

/// Follows the session from picture to picture. A step is shown once all steps before it are done, until it
/// is done itself, in any way. Window thread only.
class Lesson {
public:
    /// A part that lies this near to the place where it is to go is there, m.
    static constexpr double near = 0.2;
    /// For how long a step moves; then it is shown at rest, s.
    static constexpr double moves = 12;

    /// The session must outlive this. Not `wanted`: nothing is ever shown.
    Lesson(Session const& session, bool wanted) : session_(session), over_(!wanted) {}

    /// To be called once per picture, `seconds` after the last.
    void look(std::span<SDL_Event const> events, double seconds);
    /// The level begins again. A lesson that is over stays so.
    void restart() { done_ = 0; }

    /// nullptr: nothing is to be shown.
    [[nodiscard]] TeachingStep const* step() const;
    [[nodiscard]] InputDevice device() const { return device_; }
    /// For how long this step has been shown, s.
    [[nodiscard]] double age() const { return age_; }
    [[nodiscard]] bool moving() const { return step() != nullptr && age_ < moves; }
    [[nodiscard]] bool over() const { return over_; }

private:
    [[nodiscard]] bool isDone(TeachingStep const& step) const;

    Session const& session_;
    bool over_;
    std::size_t done_ = 0; // steps from the first one on
    double age_ = 0;
    TeachingStep const* shown_ = nullptr; // in the last picture
    InputDevice device_ = InputDevice::mouse;
};

} // namespace trembler::ui
