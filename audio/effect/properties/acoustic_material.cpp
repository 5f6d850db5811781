#include "audio/effect/properties/acoustic_material.hpp"

#include <array>
#include <cmath>

namespace trembler {

double AcousticMaterial::rodSpeed() const {
    return std::sqrt(youngsModulus / density);
}

double AcousticMaterial::shearSpeed() const {
    return std::sqrt(youngsModulus / (2 * density * (1 + poissonRatio)));
}

AcousticMaterial const& acousticMaterial(Material material) {
    using Table = std::array<AcousticMaterial, choiceNames<Material>.size()>;
    static Table const table = [] {
        // In the order of the enumeration; densities are filled in below.
        Table made{{
            {200e9, 0, 0.29, 0.0012, 0.03, 0.001}, // steel
            {170e9, 0, 0.26, 0.003, 0.03, 0.002},  // iron, cast
            {120e9, 0, 0.34, 0.002, 0.03, 0.001},  // copper
            {11e9, 0, 0.35, 0.015, 0.10, 0.003},   // wood, along the grain
            {70e9, 0, 0.22, 0.003, 0.04, 0.0005},  // glass
            {10e6, 0, 0.48, 0.3, 0.20, 0.002},     // rubber
            {50e9, 0, 0.20, 0.01, 0.02, 0.004},    // stone
            {2.5e9, 0, 0.38, 0.04, 0.06, 0.001},   // plastic
            {15e9, 0, 0.20, 0.02, 0.04, 0.005},    // brick
            {2.2e9, 0, 0.48, 0.05, 0.01, 0.01},    // water: between bodies; it sounds by bubbles
            {100e9, 0, 0.35, 0.001, 0.03, 0.001},  // gold: bell bronze
        }};
        for (std::size_t i = 0; i < made.size(); ++i) {
            made[i].density = materialFacts(static_cast<Material>(i)).density;
        }
        return made;
    }();
    return table[static_cast<std::size_t>(material)];
}

} // namespace trembler
