// How fast the forces vary that act on bodies: the summary of all calls of StateRate.
#pragma once

#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"

namespace trembler {

/// Provided by Dynamics, new whenever these calls have changed. Only bodies that move count. With a step of
/// `dt`, `greatest * dt` says how far a force turns round within it: explicit integration breaks down at 2,
/// and a force with less than about 0.5 is followed well. Zero until the first forces act, in frame 2.
struct ForceRates {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Force rates", "force_rates",
                                       "How fast the forces vary that act on bodies."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "how fast the forces vary that act";
    double greatest = 0;   ///< 1/s, of all
    double unforeseen = 0; ///< 1/s, of forces that do not allow for the time for which they stand
    ObjectId object;       ///< the body of the greatest rate; invalid while that is 0
    double swinging = 0;   ///< 1/s, of forces that bodies swing by
    double ahead = 0;      ///< 1/s, of forces that bodies swing by and that allow for the time

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "greatest", .unit = "1/s", .meaning = "rate at which a force varies"},
              self.greatest);
        visit(FieldInfo{.key = "unforeseen",
                        .unit = "1/s",
                        .meaning = "the greatest of the forces that do not allow for the time for which they "
                                   "stand"},
              self.unforeseen);
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object with the greatest rate"},
              self.object);
        visit(FieldInfo{.key = "swinging",
                        .unit = "1/s",
                        .meaning = "the greatest of the forces that depend on where an object is"},
              self.swinging);
        visit(FieldInfo{.key = "ahead",
                        .unit = "1/s",
                        .meaning = "the greatest of those that also allow for the time for which they stand"},
              self.ahead);
    }
    friend bool operator==(ForceRates const&, ForceRates const&) = default;
};

/// A force F = -k x that is found every t and acts on a mass m turns round by ω t = t √(k/m) in between. With
/// looking ahead by ForceLag, and n steps of the engine in t, the motion is a map of determinant 1: it
/// conserves (v² + ω² x²)/2 but for terms of ω t / 2n and (ω t)²/4, and so the energy ripples by these and
/// grows by nothing. Without, or from about ω t = 2 on, it grows without end. See
/// docs/measurements/stability.md for measurements.
inline constexpr double followedTurn = 0.6; ///< rad, in a part at most
/// s: how long a part of a frame may be in which a force varies at `rate` (1/s, above 0).
[[nodiscard]] constexpr double longestPart(double rate) {
    return followedTurn / rate;
}

} // namespace trembler
