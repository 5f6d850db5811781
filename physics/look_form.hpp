// As what a thing is drawn, where that is not to follow from what it is. It has no consequences: no component
// reads it.
#pragma once

#include "runtime/property/description.hpp"

#include <array>
#include <string_view>

namespace trembler {

/// The forms that any body can be drawn in. Windings and the poles of magnets are no matter of choice: they
/// show where the object's coil and poles are.
enum class LookForm : int {
    own,     ///< by what the object is in electricity and made of
    plain,   ///< its body and nothing else
    bulb,    ///< its largest piece as glass with a filament, the others as a socket
    plus,    ///< the sign of a source
    minus,   ///< the sign of a battery's other pole
    battery, ///< both of these
    earth,   ///< the sign of a return (IEC 60617)
    flash    ///< the sign of a user of electricity
};
template <>
inline constexpr std::array<std::string_view, 8> choiceNames<LookForm>{"own",   "plain",   "bulb",  "plus",
                                                                       "minus", "battery", "earth", "flash"};

/// A property of its own and not a member of Look: an object without it has the hash that it always had.
struct DrawnAs {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Form of drawing", "look_form",
        "As what the object is drawn, where that is not to follow from what it is. It has no other "
        "consequences."};
    LookForm form = LookForm::own;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "",
                        .meaning = "own: a bulb if it is of glass and uses electricity, else the sign of its "
                                   "part in electricity",
                        .required = true},
              self.form);
    }
    friend bool operator==(DrawnAs const&, DrawnAs const&) = default;
};

} // namespace trembler
