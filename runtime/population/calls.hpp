// The calls that create and destroy objects while a world runs; interactions make them (7.1.3).
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/math/vec2.hpp"
#include "runtime/property/description.hpp"

#include <array>

namespace trembler {

/// Creates an object from a prototype, which is called its birth here. `key` identifies the birth: two calls
/// with one key create one object, and ids follow from the keys, not from the order of calls. A call for an
/// unknown prototype, or with a number that is not finite, creates nothing.
struct CreateObject {
    static constexpr CallText text{
        "createObject", "(part, position, angle, velocity, spin, key)",
        "Creates an object from a part definition; calls with equal keys create one object."};
    static constexpr Algebra algebra = Algebra::create;
    std::uint32_t prototype = 0; ///< number in the PrototypeLibrary
    Vec2 position;               ///< m
    double angle = 0;            ///< rad
    Vec2 velocity;               ///< m/s
    double spin = 0;             ///< rad/s
    ObjectId maker;              ///< the object on whose behalf it is created
    std::uint64_t number = 0;    ///< unique among the births by this maker

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(
            FieldInfo{
                .key = "part", .unit = "", .meaning = "the part that it is made from", .required = true},
            self.prototype);
        visit(FieldInfo{.key = "position",
                        .unit = "m",
                        .meaning = "where",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .required = true},
              self.position);
        visit(FieldInfo{.key = "maker",
                        .unit = "",
                        .meaning = "the object on whose behalf it is created",
                        .required = true},
              self.maker);
        visit(FieldInfo{.key = "number",
                        .unit = "",
                        .meaning = "unique among the objects that this maker has created",
                        .required = true},
              self.number);
        visit(
            FieldInfo{
                .key = "angle", .unit = "rad", .meaning = "anticlockwise", .minimum = -1e6, .maximum = 1e6},
            self.angle);
        visit(FieldInfo{.key = "velocity",
                        .unit = "m/s",
                        .meaning = "of its centre",
                        .minimum = -1e4,
                        .maximum = 1e4},
              self.velocity);
        visit(
            FieldInfo{
                .key = "spin", .unit = "rad/s", .meaning = "anticlockwise", .minimum = -1e4, .maximum = 1e4},
            self.spin);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {maker}; }
    [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> key() const { return {packed(maker), number}; }
};

/// Destroys an object. A second call for the same object has no effect.
struct DestroyObject {
    static constexpr CallText text{"destroyObject", "(object)", "Removes the object from the world."};
    static constexpr Algebra algebra = Algebra::destroy;
    ObjectId object;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] std::uint64_t key() const { return packed(object); }
};

struct PopulationRole {
    static constexpr std::string_view name = "Population";
    using Calls = CallList<CreateObject, DestroyObject>;
};

} // namespace trembler
