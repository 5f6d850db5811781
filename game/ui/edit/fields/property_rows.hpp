// The rows of the inspector: properties of objects, of joints and of the world, from their descriptions.
#pragma once

#include "game/ui/edit/edit_parts.hpp"
#include "puzzle/edit/inspect/inspector.hpp"

namespace trembler::ui {

/// A property of the selected objects, with its fields, and buttons to reset and to remove it.
void drawObjectProperty(EditParts& parts, edit::InspectedProperty const& property);
/// The scripts of the selected objects: a drop-down of the scripts that the level's mods have, with the
/// widgets of their parameters.
void drawScripts(EditParts& parts, edit::InspectedProperty const* property);
void drawWorldProperty(EditParts& parts, edit::InspectedProperty const& property);

} // namespace trembler::ui
