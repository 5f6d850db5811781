// The form in which an object is drawn besides its body: as stated, else from its properties.
#pragma once

#include "physics/look_form.hpp"
#include "render/scene/facts/facts.hpp"
#include "render/scene/marks/signs.hpp"

#include <optional>

namespace trembler::render {

/// Never LookForm::own. Plain if the object has a drawing without marks. The form that the object states
/// (DrawnAs), except a bulb without a body, which cannot be drawn. Else a bulb if the object uses electricity
/// and is made of glass; else the sign of its part in electricity, see signOf(); else plain, as is a coil,
/// whose winding shows its function.
[[nodiscard]] LookForm formOf(Facts const& facts);

/// The object's part in electricity, as a sign; nothing for a plain conductor. The return is an earth, unless
/// the object states another form, or calls itself the negative pole by its label.
[[nodiscard]] std::optional<Sign> signOf(Facts const& facts);

/// The sign that is drawn where the label of the object, if it has one, is written: nothing instead of a
/// flash, which says less than the label and would be seen through it.
[[nodiscard]] std::optional<Sign> signUnderLabel(Facts const& facts, Sign sign);

/// Whether a shape of the object's drawing is drawn in its present state.
[[nodiscard]] bool isShown(DrawnWhen when, Facts const& facts);

} // namespace trembler::render
