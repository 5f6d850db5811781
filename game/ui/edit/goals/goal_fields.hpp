// Widgets for the values of a goal's condition: which objects, how far, how many.
#pragma once

#include "game/ui/edit/edit_parts.hpp"

#include <string>

namespace trembler::ui {

/// The fields of a condition of that kind, of which `body` is the value of its key. True if `body` was
/// changed. Areas are those of the scene, at parts.goalPlace.
[[nodiscard]] bool goalFields(EditParts& parts, std::string const& kind, edit::Json& body);

} // namespace trembler::ui
