// How an object is drawn if that does not follow from its material. No component reads it, so it does not
// affect the simulation.
#pragma once

#include "physics/material.hpp"
#include "runtime/property/description.hpp"

#include <array>
#include <string>

namespace trembler {

class Registry;

/// The pattern of a surface: of the object's own material, or of another one.
enum class LookPattern : int {
    own,
    steel,
    iron,
    copper,
    wood,
    glass,
    rubber,
    stone,
    plastic,
    brick,
    water,
    gold
};
template <>
inline constexpr std::array<std::string_view, 12> choiceNames<LookPattern>{
    "own",    "steel", "iron",    "copper", "wood",  "glass",
    "rubber", "stone", "plastic", "brick",  "water", "gold"};

/// The material that a pattern belongs to; not for `own`.
[[nodiscard]] constexpr Material materialOf(LookPattern pattern) {
    return static_cast<Material>(static_cast<int>(pattern) - 1);
}

struct Look {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Look", "look",
        "How the object is drawn, where that does not follow from its material. "
        "It has no other consequences."};
    LookPattern pattern = LookPattern::own;
    std::string colour; ///< "#rrggbb", or empty: the pattern's own
    std::string label;  ///< drawn on the object; at most four characters

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "pattern",
                        .unit = "",
                        .meaning = "pattern of the surface; own: that of its material"},
              self.pattern);
        visit(FieldInfo{.key = "colour", .unit = "", .meaning = "#rrggbb; left out: the pattern's own"},
              self.colour);
        visit(FieldInfo{.key = "label", .unit = "", .meaning = "up to four characters drawn on it"},
              self.label);
    }
    friend bool operator==(Look const&, Look const&) = default;
};

/// Registers the property, DrawnAs and Drawing, with the rule that a colour must be valid.
void registerLook(Registry& registry);

} // namespace trembler
