// What a thing is made of, for the eye and the ear. It moves nothing: physics has numbers of its own.
#pragma once

#include "runtime/property/description.hpp"

#include <array>
#include <string>

namespace trembler {

class Registry;

enum class Material : int { steel, iron, copper, wood, glass, rubber, stone, plastic, brick, water, gold };
template <>
inline constexpr std::array<std::string_view, 11> choiceNames<Material>{
    "steel", "iron", "copper", "wood", "glass", "rubber", "stone", "plastic", "brick", "water", "gold"};

struct Look {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Look", "look",
                                       "What the object is made of, for the eye and the ear."};
    Material material = Material::plastic;
    std::string colour; ///< "#rrggbb", or empty: the material's own
    std::string label;  ///< drawn on the object; at most four characters

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "material", .unit = "", .meaning = "what it is made of", .required = true},
              self.material);
        visit(FieldInfo{.key = "colour", .unit = "", .meaning = "#rrggbb; left out: the material's own"},
              self.colour);
        visit(FieldInfo{.key = "label", .unit = "", .meaning = "up to four characters drawn on it"},
              self.label);
    }
    friend bool operator==(Look const&, Look const&) = default;
};

/// Makes the property known, with the rule that its colour is one.
void registerLook(Registry& registry);

} // namespace trembler
