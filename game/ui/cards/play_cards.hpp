// The cards around a level: goals, toolbox, large buttons, tools, success.
#pragma once

#include "game/ui/shared/card_sizes.hpp"
#include "game/ui/shared/catalog/part_catalog.hpp"
#include "game/ui/shared/commands/command_buttons.hpp"
#include "game/ui/shared/layout.hpp"
#include "puzzle/session/session.hpp"

#include <optional>
#include <span>
#include <string>

namespace trembler::ui {

class AskedTwice;
class Celebration;
class LevelText;
class ToolboxView;

struct GoalCardLook {
    LevelText const* said = nullptr; ///< nullptr: as the level's file says it
    std::size_t hintsShown = 0;
    bool brief = false;                  ///< only the goals, without the story: another card needs the room
    bool task = false;                   ///< of a demonstration
    std::span<int const> counts{};       ///< see goalCounts()
    std::span<GoalStatus const> goals{}; ///< as they were at the moment that is shown; empty: as they are
    float below = 0;                     ///< height of the part above the buttons, pixels at UI scale 1
    bool why = false;                    ///< each goal has a button to ask why
};

struct SuccessLook {
    bool narrow = false; ///< in the toolbox's place, so that it covers nothing of the machine
    bool moving = false; ///< something may move for decoration: confetti, and the seal as it is pressed on
    char const* next = nullptr; ///< the words of the button that leads on; nullptr: "Next level"
    bool last = false;          ///< every puzzle is solved now
};

struct TransportLook {
    bool building = true; ///< the large button starts a run; otherwise it stops the one that is on
    double speed = 1;     ///< times real time
    bool late = false;    ///< the computer does not reach that speed
};

/// The part that the player carries to its place.
struct CarriedPart {
    std::string part;
    bool isNew = false; ///< it comes from the toolbox, whose count still includes it
};

struct ToolboxLook {
    std::optional<CarriedPart> carried{};
    std::string hint{};        ///< below the tiles of a small toolbox while no part is carried
    AskedTwice const& allBack; ///< whether all parts are to be put back
    bool laying = false;       ///< wires are being laid
    bool escape = false;       ///< Esc went down in this picture
};

// Each function draws its card between Gui::beginFrame and endFrame. Commands that the player asks for are
// recorded in `buttons`.

/// `buttons` is nullptr for a picture, which has no buttons. Returns the id of the goal about which the
/// player asks why.
std::optional<std::string> drawGoalCard(Layout& layout, Session const& session, GoalCardLook const& look,
                                        CommandButtons* buttons);
void drawTransport(CommandButtons& buttons, TransportLook const& look);
/// `mods`: the level has mods, and a button for them.
void drawTools(CommandButtons& buttons, Session const& session, bool mods);
/// `ran`: there is a run, and a button for its timeline.
void drawCorner(CommandButtons& buttons, bool ran);
/// Draws nothing while there is nothing to celebrate.
void drawSuccess(CommandButtons& buttons, Session const& session, Celebration const& celebration,
                 SuccessLook const& look);
/// Returns the part on whose tile the mouse button was pressed.
std::optional<std::string> drawToolbox(CommandButtons& buttons, Session const& session, PartCatalog& catalog,
                                       ToolboxView& view, ToolboxLook const& look);
/// The width of that card in the present window, pixels at UI scale 1.
[[nodiscard]] float toolboxWidthOf(Session const& session);

} // namespace trembler::ui
