// The hand while building: takes parts, turns them, lets them go, and is forgiving about it.
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

/// A part in the hand.
struct Carried {
    std::optional<int> number; ///< of the placed part that it is; none: fresh from the toolbox
    Placement landing;         ///< where it would go if it were let go now
    Verdict verdict;           ///< whether it may
    Vec2 grip;                 ///< m, from the mouse to its middle
    render::Point takenAt;     ///< pixels
    bool dragging = false;     ///< the button has been held since it was taken
    bool turning = false;      ///< held by its handle: it turns on the spot
};

/// Works on a session that is building. Window thread only.
class PlacingTool {
public:
    PlacingTool(Session& session, render::Toasts& toasts) : session_(session), toasts_(toasts) {}

    /// Takes a part from the toolbox; what was carried goes back first.
    void take(std::string const& part, Pointer const& pointer);
    /// One picture's worth of mouse. `hovered` is the placed part under it, `handle` whether it is on the
    /// handle of the selected one.
    void update(Pointer const& pointer, std::optional<int> hovered, bool onHandle);
    /// Turns what is carried, or else what is selected, by so many steps anticlockwise.
    void turn(int steps, bool fine);
    /// Moves what is selected by so many steps of the grid, a fifth of that if fine.
    void nudge(Vec2 steps, bool fine);
    /// Puts what is carried, or else what is selected, into the toolbox.
    void putBack();
    /// Lets go without changing anything. False if there was nothing to let go.
    bool cancel();
    void select(std::optional<int> number) { selected_ = number; }
    /// Forgets everything: the session runs, or is another.
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
    void moveTo(int number, Vec2 at, double angle);

    Session& session_;
    render::Toasts& toasts_;
    std::optional<Carried> carried_;
    std::optional<int> selected_;
    std::optional<Press> press_;
};

/// The angle brought to -pi..pi, and to a whole number of steps if it is that close to one.
[[nodiscard]] double tidyAngle(double angle);

} // namespace trembler::ui
