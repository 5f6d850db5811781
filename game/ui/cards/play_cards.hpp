// The cards around a level: what is wanted, the toolbox, the large buttons, the tools, success.
#pragma once

#include "game/ui/commands/command_buttons.hpp"
#include "game/ui/shared/layout.hpp"
#include "game/ui/shared/part_catalog.hpp"
#include "puzzle/session/session.hpp"

#include <optional>
#include <string>

namespace trembler::ui {

class AskedTwice;
class Celebration;
class PlacingTool;
class RunControl;

/// Widths in pixels at UI scale 1, which the other cards keep clear of.
inline constexpr float goalCardWidth = 316;
inline constexpr float toolboxWidth = 236;
inline constexpr float cardGap = 16;
inline constexpr float bottomRow = 74; ///< height of what stands at the bottom
inline constexpr float cornerRow = 74; ///< and of the buttons in the corner at the top right

struct GoalCardLook {
    std::size_t hintsShown = 0;
    bool brief = false; ///< only the goals, without the story: something else needs the room
};

// Each draws its card between Gui::beginFrame and endFrame, from what it is about. The buttons note what the
// player asks for with them.

/// `buttons` nullptr: a picture, nothing to press.
void drawGoalCard(Layout& layout, Session const& session, GoalCardLook const& look, CommandButtons* buttons);
void drawTransport(CommandButtons& buttons, RunControl const& run, AskedTwice const& allBack);
void drawTools(CommandButtons& buttons, Session const& session);
void drawCorner(CommandButtons& buttons);
/// Nothing while there is nothing to celebrate.
void drawSuccess(CommandButtons& buttons, Session const& session, Celebration const& celebration);
/// Returns the part on whose tile the mouse went down. `hint`: what is said below while nothing is carried.
std::optional<std::string> drawToolbox(Layout& layout, Session const& session, PartCatalog& catalog,
                                       PlacingTool const& placing, std::string const& hint);

} // namespace trembler::ui
