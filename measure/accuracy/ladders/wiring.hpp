// Circuits made up for measuring, and what really happens in them: Kirchhoff's laws, solved by hand.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace trembler::accuracy {

/// What an object is, with real values: none has no resistance at all, so nothing needs a special case.
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
inline constexpr double sourceOhms = 0.1; ///< inside
inline constexpr double wireOhms = 0.01;
inline constexpr double lampOhms = 12;
inline constexpr double lampWatts = sourceVolts * sourceVolts / lampOhms;
/// A lamp that takes less than this share of its rated power is dark.
inline constexpr double leastGlow = 0.01;

/// By part: V of its middle above the return. Half of a part's resistance lies between its middle and each of
/// its cables; Kirchhoff's laws by Gaussian elimination with pivoting. What floats is at 0.
[[nodiscard]] std::vector<double> potentials(Wiring const& wiring);
/// By part: A through it, half of what its cables carry in and out, from the potentials of all parts.
[[nodiscard]] std::vector<double> currents(Wiring const& wiring, std::vector<double> const& volts);
/// By part: whether it is a lamp that glows.
[[nodiscard]] std::vector<bool> glowing(Wiring const& wiring);

/// What schoolbooks ask: bridges in balance and out of it, a lamp with a wire across it, lamps in series and
/// in parallel, a dead end, a loop that leads nowhere. `count` circuits, one after the other.
[[nodiscard]] std::vector<Wiring> schoolbook(int count);
/// Parts joined at random, as if by a player: a tree and some cables more. The same for the same numbers.
[[nodiscard]] std::vector<Wiring> jumble(int count, int parts);

} // namespace trembler::accuracy
