// The cards around a level: what is wanted, the toolbox, the large buttons, the tools, success.
#pragma once

#include "game/ui/shared/command.hpp"
#include "game/ui/shared/layout.hpp"
#include "game/ui/shared/part_catalog.hpp"
#include "puzzle/session/session.hpp"

#include <optional>
#include <string>

namespace trembler::ui {

/// What the cards need to know beyond the session.
struct PlayState {
    std::size_t hintsShown = 0;
    bool fast = false;
    bool askAllBack = false;
    bool recording = false;
    bool electricity = false;
    bool magnetism = false;
    bool contacts = false;
    bool names = false;
    bool cutting = false;
    bool components = false;
    bool celebrating = false;
    bool goalsShort = false;        ///< only the goals, without the story: something else needs the room
    bool still = false;             ///< a picture: nothing to press
    bool carrying = false;          ///< something is in the hand
    double celebratedFor = 0;       ///< s
    std::optional<double> solvedAt; ///< s of the run
    bool nextLevel = false;         ///< there is one
    std::string carriedPart;
};

/// Widths in pixels at UI scale 1, which the other cards keep clear of.
inline constexpr float goalCardWidth = 316;
inline constexpr float toolboxWidth = 236;
inline constexpr float cardGap = 16;
inline constexpr float bottomRow = 74; ///< height of what stands at the bottom
inline constexpr float cornerRow = 74; ///< and of the buttons in the corner at the top right

// Each draws its card between Gui::beginFrame and endFrame and returns what the player asked for with it.
std::optional<Command> drawGoalCard(Layout& layout, Session const& session, PlayState const& state);
std::optional<Command> drawTransport(Layout& layout, Session const& session, PlayState const& state);
std::optional<Command> drawTools(Layout& layout, Session const& session, PlayState const& state);
std::optional<Command> drawCorner(Layout& layout);
std::optional<Command> drawSuccess(Layout& layout, Session const& session, PlayState const& state);
/// Returns the part on whose tile the mouse went down.
std::optional<std::string> drawToolbox(Layout& layout, Session const& session, PartCatalog& catalog,
                                       PlayState const& state);
void drawHelp(Layout& layout, bool& open);

} // namespace trembler::ui
