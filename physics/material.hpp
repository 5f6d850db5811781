// The material of an object, and the numbers that follow from it unless others are stated.
#pragma once

#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

class Registry;

enum class Material : int { steel, iron, copper, wood, glass, rubber, stone, plastic, brick, water, gold };
template <>
inline constexpr std::array<std::string_view, 11> choiceNames<Material>{
    "steel", "iron", "copper", "wood", "glass", "rubber", "stone", "plastic", "brick", "water", "gold"};

/// Each effect takes its own properties from it: Dynamics density, friction and restitution, Electricity
/// whether it conducts, Magnetism how strongly magnets pull it, Sound how it rings and how much sound it
/// absorbs. Properties that an object states, or that it states not to have ("conductor": false), always have
/// precedence. The material also determines the look, unless the object states a Look; a Look affects nothing
/// else.
struct MadeOf {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Material", "material",
        "The material of the object. Where not stated, it determines density, friction, restitution, sound, "
        "conduction, attraction by magnets and look."};
    Material material = Material::plastic;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "", .meaning = "kind of material", .required = true},
              self.material);
    }
    friend bool operator==(MadeOf const&, MadeOf const&) = default;
};

/// The numbers of a material for motion, electricity and magnetism. See also acousticMaterial().
struct MaterialFacts {
    double density = 0; ///< kg/m³, of the solid material
    double friction = 0;
    double restitution = 0;
    bool conducts = false;
    double saturation = 0; ///< A/m, the magnetisation by a strong magnet; 0: none
};

/// Densities as in Fletcher and Rossing, The Physics of Musical Instruments (1998), Chapter 22, and for
/// materials that do not ring as in the CRC Handbook of Chemistry and Physics; iron is cast, wood is spruce
/// or pine along the grain, "gold" is the look of bells, with the numbers of bronze. Saturation of iron as in
/// Cullity and Graham, Introduction to Magnetic Materials (2009), Chapter 4; steel with some carbon has a
/// little less. Friction and restitution depend on both surfaces, their wear and the speed more than on the
/// material: they are medium values for dry, worn surfaces, chosen by hand.
[[nodiscard]] MaterialFacts const& materialFacts(Material material);

/// Registers the property.
void registerMaterial(Registry& registry);

} // namespace trembler
