// The view of a level shows the whole of it beside the cards, until the player moves it by hand.
#pragma once

#include "game/ui/play/view/level_extents.hpp"
#include "game/ui/shared/layout.hpp"
#include "puzzle/session/placements.hpp"

#include <array>
#include <optional>
#include <vector>

namespace trembler::ui {

struct PlayParts;

/// Two kinds of cards are kept clear. Cards that always stand around the level (goal, toolbox, buttons) count
/// as they were while the player built, so that the view does not move when a run begins. Cards that the
/// player opens and closes (components, mods, inspector, why, the legend of overlays) count while they are
/// open, also in a run, over their whole column down to the buttons, so that the view moves once and not with
/// each line in them. In a window without room for the level beside such a card, the card lies over it: see
/// worthwhile in the source file. Places that are empty may lie under the goal card, which is hidden while a
/// part is held; if a part is placed there, the view is fitted again. Window thread only.
class FittedView {
public:
    /// Once for each picture, before its cards are drawn. `cards`: the last picture had them.
    void follow(PlayParts& parts, bool cards);

private:
    using Cards = std::vector<Rect>;

    /// Return whether anything changed.
    bool lookAtWindow(PlayParts const& parts);
    bool lookAtStanding(PlayParts const& parts);
    bool lookAtOpened(PlayParts const& parts);
    /// Returns whether the level has room between the cards at the sides.
    bool setMargins(PlayParts& parts) const;
    void fit(PlayParts& parts, bool room) const;
    /// Returns whether the player has placed, moved or removed parts, so that one lies under a card now.
    bool lookAtPlaced(PlayParts& parts);
    [[nodiscard]] Cards onlyGoal() const;
    [[nodiscard]] Cards obstacles(bool withOpened, bool withGoal = true) const;

    std::array<std::optional<Rect>, 5> standing_;
    std::array<std::optional<Rect>, 3> opened_; ///< at the left, at the right, above the tools
    std::array<int, 3> missing_{};              ///< pictures since there was a card there
    render::Size window_;                       ///< of which the cards are
    double scale_ = 0;                          ///< of the interface
    float timeline_ = 0;                        ///< its height, pixels at UI scale 1
    LevelExtents extents_;
    std::vector<PlacedPart> placed_;
    bool toolbox_ = true; ///< it counts: not beside a card that was opened in a run, which hides it
    bool wasBuilding_ = true;
};

} // namespace trembler::ui
