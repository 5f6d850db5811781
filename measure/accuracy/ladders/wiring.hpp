// Circuits generated for measurements, with a reference solution of Kirchhoff's laws.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace trembler::accuracy {

/// Kind of a part. All parts have a resistance above zero, so the solver needs no special case.
enum class Part : std::uint8_t { source, earth, wire, lamp };

/// One circuit with a source of 12 V and a return.
struct Wiring {
    std::vector<Part> parts;
    std::vector<double> ohms;                                    ///< of each part
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cables; ///< between parts; one per pair

    std::uint32_t add(Part part, double ohm);
    void cable(std::uint32_t a, std::uint32_t b);
};

inline constexpr double sourceVolts = 12;
inline constexpr double sourceOhms = 0.1; ///< internal resistance of the source
inline constexpr double wireOhms = 0.01;
inline constexpr double lampOhms = 12;
inline constexpr double lampWatts = sourceVolts * sourceVolts / lampOhms;
/// A lamp with less than this share of its rated power counts as dark.
inline constexpr double leastGlow = 0.01;

/// The potentials by part: V of the part's middle above the return. Half of a part's resistance lies between
/// its middle and each of its cables; solved by Gaussian elimination with pivoting. Floating parts are at 0.
[[nodiscard]] std::vector<double> potentials(Wiring const& wiring);
/// The currents by part: A through it, half of the sum of the currents in its cables, from the potentials of
/// all parts.
[[nodiscard]] std::vector<double> currents(Wiring const& wiring, std::vector<double> const& volts);
/// By part: whether it is a lamp with at least leastGlow of its rated power.
[[nodiscard]] std::vector<bool> glowing(Wiring const& wiring);

/// Textbook circuits: balanced and unbalanced bridges, a lamp with a wire across it, lamps in series and in
/// parallel, a dead end, an isolated loop. Returns `count` circuits, cycling through these kinds.
[[nodiscard]] std::vector<Wiring> schoolbook(int count);
/// Parts connected at random, as a player might: a tree and a few more cables. Deterministic for equal
/// arguments.
[[nodiscard]] std::vector<Wiring> jumble(int count, int parts);

} // namespace trembler::accuracy
