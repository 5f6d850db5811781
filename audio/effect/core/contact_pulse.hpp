// The force of an impact that excites modes: its duration and its spectrum.
#pragma once

#include "audio/effect/properties/acoustic_material.hpp"
#include "physics/dynamics/properties/shape.hpp"

namespace trembler {

/// The radius of curvature, in m, of a round body at the contact; 0 for a body that is flat or has corners.
[[nodiscard]] double roundnessOf(Shape const& shape);

/// How long two bodies stay in touch in an impact, in s, by Hertz (Johnson, Contact Mechanics, 1985, Section
/// 11.4): 2.87 (m² / (R E*² v))^(1/5). `mass` is the reduced mass of the two, in kg, `roundnessA` and
/// `roundnessB` the radii where they touch (0: flat; two flat bodies touch with an edge of 5 mm), `speed`
/// that of approach, in m/s. Harder bodies and harder impacts give shorter times. Between 20 µs and 50 ms.
[[nodiscard]] double contactTime(Material a, Material b, double roundnessA, double roundnessB, double mass,
                                 double speed);

/// The share of an impact's impulse that excites a mode of that frequency: the envelope of the spectrum of
/// half a sine that lasts `contact` (s). 1 for low frequencies, decreasing by 12 dB per octave above 1/(2
/// contact).
[[nodiscard]] double spectrumOf(double contact, double frequency);

/// The sound pressure (Pa at 1 m) of a body that is jerked into motion, the click of an impact, over a whole
/// period of a sine that lasts as long as the contact. `movedAir` in m³, `mass` in kg, `impulse` in N s,
/// `contact` in s. An accelerated body is an acoustic dipole: p = ρ V / (4π c r) da/dt along its motion
/// (Chadwick, Zheng and James, Precomputed acceleration noise, ACM Trans. Graphics 31, 2012).
[[nodiscard]] double clickPressure(double movedAir, double mass, double impulse, double contact);

} // namespace trembler
