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

/// Lengths in pixels at UI scale 1.
struct GoalCardLook {
    LevelText const* said = nullptr; ///< nullptr: as the level's file says it
    /// Of a strip above the scene, in which story and goals stand side by side if there is room; 0: a column
    /// beside the scene.
    float width = 0;
    float most = 0;                      ///< the most height of the strip; more text scrolls
    bool brief = false;                  ///< only the goals, without the story: another card needs the room
    bool task = false;                   ///< of a demonstration
    std::span<int const> counts{};       ///< see goalCounts()
    std::span<GoalStatus const> goals{}; ///< as they were at the moment that is shown; empty: as they are
    bool why = false;                    ///< each goal has a button to ask why
    std::optional<bool> storyOpen{};     ///< the player's choice where the story has little room
    char const* hint = nullptr;          ///< the words of the button for hints; nullptr: there is none
};

/// The player's requests to the goal card.
struct GoalCardAsked {
    std::optional<std::string> why; ///< the id of the goal about which the player asks
    std::optional<bool> storyOpen;  ///< the story is to be shown, or hidden
};

/// Whether story and goals stand side by side on a strip of this width.
[[nodiscard]] bool isWideStrip(float width);

struct HintCardLook {
    std::span<std::string const> hints{}; ///< those that the player has asked for
    std::size_t total = 0;                ///< of the level
    std::size_t at = 0;                   ///< the one that is shown
    float top = 0;                        ///< of the card
    float most = 0;                       ///< its most height; more text scrolls
};

/// The player's requests to the card of hints.
struct HintCardAsked {
    std::optional<std::size_t> at; ///< another hint is to be shown
    bool fold = false;
};

struct SuccessLook {
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

/// `buttons` is nullptr for a picture, which has no buttons.
GoalCardAsked drawGoalCard(Layout& layout, Session const& session, GoalCardLook const& look,
                           CommandButtons* buttons);
/// One hint at a time, at the left below the goals, over the scene.
HintCardAsked drawHintCard(Layout& layout, HintCardLook const& look);
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
/// Whether it has so many parts that it is wide, in groups and with a search: see toolboxWidth().
[[nodiscard]] bool hasLargeToolbox(Session const& session);

} // namespace trembler::ui
