// A number that is typed after one click, or dragged.
#pragma once

#include <string>

namespace trembler::ui {

struct EditParts;

/// True while it changes; EditParts::widget is then the gesture of its changes. One click begins to type, Tab
/// goes on to the next field, a drag changes the number. A number that is too long for its field is shown
/// with fewer digits, never cut; the tip then states all of them.
[[nodiscard]] bool numberField(EditParts& parts, std::string const& item, double& value, double low,
                               double high, std::string const& unit, bool whole = false);

} // namespace trembler::ui
