// The interaction functions of the Sound resolver.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/math/vec2.hpp"
#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

/// An impact. Impacts add up: each excites every mode by its own amount, so sound energies are summed in any
/// order of calls. Two bodies that collide make two calls, one for each.
struct Strike {
    static constexpr CallText text{"strike", "(object, other, point, normal, impulse, contact, since)",
                                   "Excites the object's modes by an impact with the other object, once."};
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
    ObjectId object;
    ObjectId other;
    Vec2 point;         ///< m, in the object's frame
    Vec2 normal;        ///< unit, in the object's frame: the direction in which the object is pushed
    double impulse = 0; ///< N s
    double contact = 0; ///< s, how long the impact lasts; 0: as long as Hertz's law says of these two
    double since = 0;   ///< s, from the beginning of the frame to the impact
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "what rings", .required = true}, self.object);
        visit(FieldInfo{.key = "other", .unit = "", .meaning = "what it is hit by", .required = true},
              self.other);
        visit(FieldInfo{.key = "point",
                        .unit = "m",
                        .meaning = "in the object's frame",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .required = true},
              self.point);
        visit(FieldInfo{.key = "normal",
                        .unit = "",
                        .meaning = "unit vector in the object's frame: which way the object is pushed",
                        .minimum = -2,
                        .maximum = 2,
                        .required = true},
              self.normal);
        visit(FieldInfo{.key = "impulse",
                        .unit = "N s",
                        .meaning = "how hard",
                        .minimum = 0,
                        .maximum = 1e12,
                        .required = true},
              self.impulse);
        visit(FieldInfo{.key = "contact",
                        .unit = "s",
                        .meaning = "how long the impact lasts; 0: as long as their materials, masses and "
                                   "roundness make it",
                        .minimum = 0,
                        .maximum = 10},
              self.contact);
        visit(FieldInfo{.key = "since",
                        .unit = "s",
                        .meaning = "from the beginning of the frame to the impact",
                        .minimum = 0,
                        .maximum = 10},
              self.since);
    }
    [[nodiscard]] std::array<ObjectId, 2> objects() const { return {object, other}; }
    [[nodiscard]] std::pair<ObjectId, ObjectId> key() const { return {object, other}; }
};

/// Rubbing or rolling: a noise of small impacts while the call is held. Their energies add up.
struct Rub {
    static constexpr CallText text{
        "rub", "(object, other, point, normal, force, bandwidth)",
        "Excites the object's modes by the noise of its surface rubbing on the other one."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    static constexpr double negligible = 1e-6; ///< N
    ObjectId object;
    ObjectId other;
    Vec2 point;           ///< m, in the object's frame
    Vec2 normal;          ///< unit, in the object's frame, into the object
    double force = 0;     ///< N, root mean square of the noise
    double bandwidth = 0; ///< Hz: bumps per second
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "what rings", .required = true}, self.object);
        visit(FieldInfo{.key = "other", .unit = "", .meaning = "what rubs", .required = true}, self.other);
        visit(FieldInfo{.key = "point",
                        .unit = "m",
                        .meaning = "in the object's frame",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .required = true},
              self.point);
        visit(FieldInfo{.key = "normal",
                        .unit = "",
                        .meaning = "unit vector in the object's frame, into the object",
                        .minimum = -2,
                        .maximum = 2,
                        .required = true},
              self.normal);
        visit(FieldInfo{.key = "force",
                        .unit = "N",
                        .meaning = "root mean square of the noise",
                        .minimum = 0,
                        .maximum = 1e12,
                        .required = true},
              self.force);
        visit(FieldInfo{.key = "bandwidth",
                        .unit = "Hz",
                        .meaning = "bumps per second",
                        .minimum = 0,
                        .maximum = 1e6,
                        .required = true},
              self.bandwidth);
    }
    [[nodiscard]] std::array<ObjectId, 2> objects() const { return {object, other}; }
    [[nodiscard]] std::pair<ObjectId, ObjectId> key() const { return {object, other}; }
    [[nodiscard]] double magnitude() const { return force; }
};

/// Plays the object's recording from its beginning. Several calls in one frame play it once, as loud as all
/// together.
struct PlaySample {
    static constexpr CallText text{"playSample", "(object, share)",
                                   "Plays the object's recording once, at that share of its full power."};
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
    ObjectId object;
    double share = 1; ///< of its sound power; sums count as 1 at most
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "what has the recording", .required = true},
              self.object);
        visit(
            FieldInfo{
                .key = "share", .unit = "", .meaning = "of its sound power", .minimum = 0, .maximum = 1},
            self.share);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] ObjectId key() const { return object; }
};

/// Repeats the object's recording while any interaction makes this call.
struct HoldSample {
    static constexpr CallText text{"holdSample", "(object)",
                                   "Repeats the object's recording while any interaction holds the call."};
    static constexpr Algebra algebra = Algebra::anyOf;
    ObjectId object;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "what has the recording", .required = true},
              self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] ObjectId key() const { return object; }
};

struct SoundRole {
    static constexpr std::string_view name = "Sound";
    using Calls = CallList<Strike, Rub, PlaySample, HoldSample>;
};

} // namespace trembler
