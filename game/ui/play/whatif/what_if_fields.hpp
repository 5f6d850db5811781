// The fields of an object at the moment of a what-if, with a widget each.
#pragma once

#include "game/ui/play/whatif/what_if.hpp"
#include "game/ui/shared/layout.hpp"

#include <string>

namespace trembler::ui {

/// The object's name and all its fields that can be set; changes the fields that the player sets. Items are
/// called "set PROPERTY.FIELD". Inside a card.
void drawWhatIfFields(Layout& layout, WhatIfView& view, std::string const& object);

} // namespace trembler::ui
