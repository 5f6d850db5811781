// Numbers of materials for vibration and absorption.
#pragma once

#include "physics/material.hpp"

namespace trembler {

struct AcousticMaterial {
    double youngsModulus = 0; ///< Pa
    double density = 0;       ///< kg/m³, of the solid material; an object may be hollow
    double poissonRatio = 0;
    double lossFactor =
        0; ///< share of a mode's energy that a period of vibration turns into heat, divided by 2π
    double absorption = 0; ///< share of the sound that a surface absorbs, at about 1 kHz
    double roughness = 0;  ///< m, the typical length of the surface's bumps

    /// Speed of long waves along a thin rod, in m/s: sqrt(E/ρ).
    [[nodiscard]] double rodSpeed() const;
    /// Speed of shear waves, in m/s: sqrt(E / (2 ρ (1 + ν))).
    [[nodiscard]] double shearSpeed() const;
};

/// Textbook values: densities are those of materialFacts(), moduli as in Fletcher and Rossing, The Physics of
/// Musical Instruments (1998), Chapter 22; loss factors as in Cremer, Heckl and Petersson, Structure-Borne
/// Sound (2005), towards the upper end, as bodies in levels are not freely suspended; absorption as in
/// Kuttruff, Room Acoustics (2000), Chapter 9. Roughness is an estimate by hand. "gold" is the look of bells,
/// with the numbers of bronze.
[[nodiscard]] AcousticMaterial const& acousticMaterial(Material material);

} // namespace trembler
