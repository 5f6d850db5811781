#include "audio/effect/acoustic_material.hpp"

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
    // In the order of the enumeration.
    static constexpr std::array<AcousticMaterial, choiceNames<Material>.size()> table{{
        {200e9, 7850, 0.29, 0.0012, 0.03, 0.001}, // steel
        {170e9, 7300, 0.26, 0.003, 0.03, 0.002},  // iron, cast
        {120e9, 8900, 0.34, 0.002, 0.03, 0.001},  // copper
        {11e9, 600, 0.35, 0.015, 0.10, 0.003},    // wood, along the grain
        {70e9, 2500, 0.22, 0.003, 0.04, 0.0005},  // glass
        {10e6, 1100, 0.48, 0.3, 0.20, 0.002},     // rubber
        {50e9, 2600, 0.20, 0.01, 0.02, 0.004},    // stone
        {2.5e9, 1050, 0.38, 0.04, 0.06, 0.001},   // plastic
        {15e9, 1900, 0.20, 0.02, 0.04, 0.005},    // brick
        {2.2e9, 1000, 0.48, 0.05, 0.01, 0.01},    // water: for what lies in between; it sounds by bubbles
        {100e9, 8700, 0.35, 0.001, 0.03, 0.001},  // gold: bell bronze
    }};
    return table[static_cast<std::size_t>(material)];
}

} // namespace trembler
