// The view of a level shows the whole of it beside the cards, and then holds still.
#pragma once

#include "game/ui/play/view/level_extents.hpp"
#include "game/ui/shared/layout.hpp"

#include <array>
#include <optional>
#include <vector>

namespace trembler::ui {

struct PlayParts;

/// Fits the view when a level is opened, when the window or its letters have another size, and when the
/// player asks for it (PlayParts::fitWanted): as soon as the cards around the level know their sizes, at most
/// `settling` pictures later. Otherwise nothing but the player moves it: cards that open, grow or go lie over
/// the scene or leave it free, and it stays where it is, so that nobody aims at what moves.
///
/// Two kinds of cards are kept clear. Those that always stand around the level (goal, toolbox, buttons) leave
/// the stage free, a rectangle of at least `stageShare` of the window's width; the toolbox counts in a run,
/// too, as it comes back. Cards that the player has opened (components, mods, inspector, why, the legend of
/// overlays) count when the player asks to see everything, over their whole column down to the buttons. With
/// those of the past (the timeline with its plots, the card of what-if or of plots) the player works on the
/// scene: they count whenever the view is fitted. In a window without room for the level beside such a card,
/// the card lies over it: see worthwhile in the source file. Window thread only.
class FittedView {
public:
    /// Once for each picture, before its cards are drawn. `cards`: the last picture had them.
    void follow(PlayParts& parts, bool cards);
    /// The rectangle that the cards around the level leave free, as it was when the view was fitted, pixels.
    [[nodiscard]] Rect const& stage() const { return stage_; }
    /// Whether the view is not fitted yet.
    [[nodiscard]] bool settles() const { return pictures_ >= 0; }

    /// The most pictures with cards until the view is fitted: a card has its size in its third.
    static constexpr int settling = 5;

private:
    using Cards = std::vector<Rect>;

    void lookAtWindow(PlayParts& parts);
    /// Return whether anything changed.
    bool lookAtStanding(PlayParts const& parts);
    /// Where a card is, and what is below it down to the buttons.
    [[nodiscard]] std::optional<Rect> columnOf(PlayParts const& parts, char const* name) const;
    void lookAtPast(PlayParts const& parts);
    void lookAtOpened(PlayParts const& parts);
    void setStage(PlayParts& parts);
    void fit(PlayParts& parts) const;
    [[nodiscard]] std::optional<Rect> toolboxPlace(PlayParts const& parts) const;
    [[nodiscard]] std::optional<Rect> standing(PlayParts const& parts, std::size_t i, bool withOpened) const;
    [[nodiscard]] Cards obstacles(PlayParts const& parts, bool withOpened) const;

    std::array<std::optional<Rect>, 5> standing_;
    std::array<std::optional<Rect>, 3> opened_; ///< at the left, at the right, above the tools
    std::optional<Rect> ofPast_;                ///< above the timeline
    render::Size window_;                       ///< of which the cards are
    double scale_ = 0;                          ///< of the interface
    float timeline_ = 0;                        ///< its height, pixels at UI scale 1
    LevelExtents extents_;
    Rect stage_;
    double goalHeight_ = 140; ///< of its card while the player builds, pixels at UI scale 1
    int pictures_ = 0;        ///< with cards of this window since it has its size; -1: the view is fitted
    bool wasBuilding_ = true;
};

} // namespace trembler::ui
