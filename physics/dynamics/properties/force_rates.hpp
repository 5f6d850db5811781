// How fast the forces on bodies vary: the summary of all calls of StateRate.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"

namespace trembler {

/// Provided by Dynamics, updated whenever these calls have changed. Only movable bodies count. `greatest *
/// dt` is the phase by which a force varies within a step of `dt`: explicit integration is unstable from 2
/// on, and accurate below about 0.5. Zero until the first forces act, in frame 2.
struct ForceRates {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Force rates", "force_rates", "How fast the forces on bodies vary."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "how fast the forces on bodies vary";
    double greatest = 0;   ///< 1/s, of all
    double unforeseen = 0; ///< 1/s, of forces that do not compensate the lag
    ObjectId object;       ///< the body of the greatest rate; invalid while that is 0
    double swinging = 0;   ///< 1/s, of forces by which bodies swing
    double ahead = 0;      ///< 1/s, of forces by which bodies swing and that compensate the lag

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "greatest", .unit = "1/s", .meaning = "greatest rate at which a force varies"},
              self.greatest);
        visit(
            FieldInfo{
                .key = "unforeseen",
                .unit = "1/s",
                .meaning =
                    "greatest rate of the forces that do not allow for the time for which they are held"},
            self.unforeseen);
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "object with the greatest rate"},
              self.object);
        visit(FieldInfo{.key = "swinging",
                        .unit = "1/s",
                        .meaning = "greatest rate of the forces that depend on the position of an object"},
              self.swinging);
        visit(
            FieldInfo{
                .key = "ahead",
                .unit = "1/s",
                .meaning =
                    "greatest rate of those of these forces that allow for the time for which they are held"},
            self.ahead);
    }
    friend bool operator==(ForceRates const&, ForceRates const&) = default;
};

/// A force F = -k x that is computed once per time t and acts on a mass m varies by the phase ω t = t √(k/m)
/// in between. With compensation of ForceLag, and n steps of the engine in t, the motion is a map of
/// determinant 1: it conserves (v² + ω² x²)/2 except for terms of ω t / 2n and (ω t)²/4, so the energy
/// ripples by these and does not grow. Without compensation, or from about ω t = 2 on, it grows without
/// bound. See docs/measurements/stability.md for measurements.
inline constexpr double followedTurn = 0.6; ///< rad, the greatest phase in a part
/// The longest part of a frame, in s, for a force that varies at `rate` (1/s, above 0).
[[nodiscard]] constexpr double longestPart(double rate) {
    return followedTurn / rate;
}

} // namespace trembler
