// The head of a large toolbox: a field in which a part is sought by its name, and the groups of the parts.
#pragma once

#include "game/ui/cards/toolbox_view.hpp"
#include "game/ui/shared/commands/command_buttons.hpp"

#include <vector>

namespace trembler::ui {

/// Inside the toolbox's card, above its tiles. Esc (`escape`: it went down in this picture) leaves the field
/// and ends the search; Enter takes the first part that was found. `brief`: in one line, with a button that
/// has the view offer the groups; else with a heading and a button for each group.
void drawToolboxFinder(CommandButtons& buttons, std::vector<ToolboxSlot> const& slots, PartCatalog& catalog,
                       ToolboxView& view, bool escape, bool brief);

/// In place of the tiles: the groups by their names, to choose one.
void drawGroupList(Layout& layout, std::vector<ToolboxSlot> const& slots, PartCatalog& catalog,
                   ToolboxView& view);

/// The name of a group in the language in use.
[[nodiscard]] char const* nameOf(PartGroup group);

} // namespace trembler::ui
