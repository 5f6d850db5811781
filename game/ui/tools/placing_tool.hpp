// The hand while building: takes parts, turns and places them, and looks for the nearest free place.
#pragma once

#include "game/ui/shared/pointer.hpp"
#include "puzzle/session/session.hpp"
#include "render/panels/toasts.hpp"

#include <optional>
#include <string>

namespace trembler::ui {

/// Steps of the grid and of turning.
inline constexpr double gridStep = 0.05; ///< m
inline constexpr double turnStep = pi / 12;
inline constexpr double fineTurnStep = pi / 180;

/// A part that is being placed.
struct Carried {
    std::optional<int> number; ///< of the placed part that was picked up; nullopt: new from the toolbox
    Placement landing;         ///< its place if it is released now
    Verdict verdict;           ///< whether that place is allowed
    Vec2 grip;                 ///< m, from the mouse to the part's origin
    render::Point takenAt;     ///< pixels
    bool dragging = false;     ///< the button has been held since the part was taken
    bool turning = false;      ///< held by its handle: it rotates in place
    bool handleBelow = false;  ///< and that is the one on the part's lower side
};

/// Acts on a session in its building phase. Window thread only.
class PlacingTool {
public:
    PlacingTool(Session& session, render::Toasts& toasts) : session_(session), toasts_(toasts) {}

    /// Takes a part from the toolbox; a part that is carried goes back first.
    void take(std::string const& part, Pointer const& pointer);
    /// The carried part was taken by a key: it follows the pointer until the next press.
    void keepInHand() {
        if (carried_) {
            carried_->dragging = false;
        }
    }
    /// Handles one picture's mouse input. `hovered` is the placed part under the mouse, `onHandle` whether
    /// the mouse is on the handle of the selected part.
    void update(Pointer const& pointer, std::optional<int> hovered, bool onHandle);
    /// Turns the carried or else the selected part by `steps` anticlockwise.
    void turn(int steps, bool fine);
    /// Mirrors the carried or else the selected part from left to right, as it is seen.
    void flip();
    /// Moves the selected part by steps of the grid, or by a fifth of that if `fine`.
    void nudge(Vec2 steps, bool fine);
    /// Returns the carried or else the selected part to the toolbox.
    void putBack();
    /// Lets go of the carried part, or of a press on one, without changing anything. Returns false if there
    /// was neither.
    bool cancel();
    void select(std::optional<int> number) { selected_ = number; }
    /// Forgets everything: call when the session starts to run or is replaced.
    void reset();

    [[nodiscard]] std::optional<Carried> const& carried() const { return carried_; }
    [[nodiscard]] std::optional<int> selected() const { return selected_; }
    /// Where a placed part is.
    [[nodiscard]] Placement const* placementOf(int number) const;

private:
    struct Press {
        int number = 0;
        Vec2 grip;
        render::Point at;
    };

    void follow(Pointer const& pointer);
    void settle(Placement const& wanted, double reach);
    void drop();
    void pickUp(int number, Vec2 grip, Pointer const& pointer);
    void updateCarried(Pointer const& pointer);
    void updateFree(Pointer const& pointer, std::optional<int> hovered, bool onHandle);
    void moveTo(int number, Placement const& wanted);
    /// The same if the session allows it; else says why it does not.
    void tryMove(int number, Placement const& wanted);

    Session& session_;
    render::Toasts& toasts_;
    std::optional<Carried> carried_;
    std::optional<int> selected_;
    std::optional<Press> press_;
};

/// The placement mirrored from left to right, as it is seen: about the vertical line through `x`, m.
[[nodiscard]] Placement mirroredAcross(Placement placement, double x);

/// The angle normalised to -pi..pi, and rounded to a whole number of steps if it is within rounding error of
/// one.
[[nodiscard]] double tidyAngle(double angle);

} // namespace trembler::ui
