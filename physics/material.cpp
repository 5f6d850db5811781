#include "physics/material.hpp"

#include "runtime/object/without.hpp"
#include "runtime/world/registry.hpp"

namespace trembler {

MaterialFacts const& materialFacts(Material material) {
    // In the order of the enumeration.
    static constexpr std::array<MaterialFacts, choiceNames<Material>.size()> table{{
        {7850, 0.4, 0.1, true, 1.6e6}, // steel
        {7300, 0.4, 0.1, true, 1.7e6}, // iron
        {8900, 0.4, 0.1, true, 0},     // copper
        {600, 0.5, 0.1, false, 0},     // wood
        {2500, 0.2, 0.05, false, 0},   // glass
        {1100, 0.9, 0.8, false, 0},    // rubber
        {2600, 0.7, 0.05, false, 0},   // stone
        {1050, 0.4, 0.1, false, 0},    // plastic
        {1900, 0.8, 0.05, false, 0},   // brick
        {1000, 0.05, 0, false, 0},     // water
        {8700, 0.3, 0.4, true, 0},     // gold
    }};
    return table[static_cast<std::size_t>(material)];
}

void registerMaterial(Registry& registry) {
    registry.property<MadeOf>();
    registry.property<Without>();
}

} // namespace trembler
