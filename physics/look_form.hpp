// The form in which an object is drawn if it must not follow from its properties. No component reads it, so
// it does not affect the simulation.
#pragma once

#include "runtime/property/description.hpp"

#include <array>
#include <string_view>

namespace trembler {

/// The forms in which any body can be drawn. Windings and the poles of magnets cannot be chosen: they show
/// the object's coil and poles.
enum class LookForm : int {
    own,     ///< from the object's electrical properties and material
    plain,   ///< its body only
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

/// Not a member of Look, as a new member would change the hash of every object that has a Look.
struct DrawnAs {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Form of drawing", "look_form",
                                       "The symbol by which the object is drawn, where it should not follow "
                                       "from its other properties. It has no other consequences."};
    LookForm form = LookForm::own;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value",
                        .unit = "",
                        .meaning = "own: a bulb if it is of glass and uses electricity, else the symbol of "
                                   "its function in electricity",
                        .required = true},
              self.form);
    }
    friend bool operator==(DrawnAs const&, DrawnAs const&) = default;
};

} // namespace trembler
