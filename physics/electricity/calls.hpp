// The interaction functions of the Electricity resolver.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/property/description.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace trembler {

/// The common part of the calls that change connections. Their algebra is the counted set: the calls of one
/// frame and one caller on one pair of objects are added up before they take effect, so their order does not
/// matter; the pair is connected while any caller's count is above zero (CallerCounts). So the graph stores
/// which caller connects two objects: this replaces the thesis's doubled vertices, without their cost. The
/// removal of a connection that the caller has not added has no effect: the caller's count stays zero, and no
/// other caller's count changes. When an interaction is removed, so are the connections that it has added.
struct ConnectionKey {
    static constexpr Algebra algebra = Algebra::countedSet;
    ObjectId a;
    ObjectId b;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "a", .unit = "", .meaning = "one conductor", .required = true}, self.a);
        visit(FieldInfo{.key = "b", .unit = "", .meaning = "the other conductor", .required = true}, self.b);
    }
    [[nodiscard]] std::array<ObjectId, 2> objects() const { return {a, b}; }
    [[nodiscard]] auto key() const { return a < b ? std::pair{a, b} : std::pair{b, a}; }
};

/// Adds one to the caller's count of a connection.
struct AddConnection : ConnectionKey {
    using MembersOf = ConnectionKey;
    static constexpr CallText text{
        "addConnection", "(object, object)",
        "Adds one to the caller's count of connections between two conductors; they "
        "are connected while any caller's count is above zero."};
    [[nodiscard]] int delta() const { return 1; }
};

/// Subtracts one from the caller's count of a connection.
struct RemoveConnection : ConnectionKey {
    using MembersOf = ConnectionKey;
    static constexpr CallText text{"removeConnection", "(object, object)",
                                   "Subtracts one from the caller's own count of connections between two "
                                   "conductors, but not below zero."};
    [[nodiscard]] int delta() const { return -1; }
};

/// Connects two conductors for as long as the call is held; its end needs no other call. Used instead of the
/// two calls above by interactions that compute the connections again in each turn and do not record the
/// connections that they have added. It counts as one of the caller's connections between the two, however
/// often the caller holds it.
struct HoldConnection : ConnectionKey {
    using MembersOf = ConnectionKey;
    static constexpr CallText text{
        "holdConnection", "(object, object)",
        "Connects two conductors for as long as the call is held, as one of the caller's connections."};
    static constexpr Algebra algebra = Algebra::anyOf;
    static constexpr bool hashedOnlyIfMade = true;
};

/// Raises the EMF of a source, as induction does; several calls add up. The call has no effect on an object
/// without an EMF, as its voltage is unknown.
struct AddVoltage {
    static constexpr CallText text{
        "addVoltage", "(object, voltage)",
        "Adds a voltage (V) to the EMF of a source for as long as the call is held."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    static constexpr double negligible = 1e-9; ///< V
    static constexpr bool hashedOnlyIfMade = true;
    ObjectId object;
    double voltage = 0; ///< V
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "a source with an EMF", .required = true},
              self.object);
        visit(FieldInfo{.key = "voltage",
                        .unit = "V",
                        .meaning = "added to its EMF",
                        .minimum = -1e6,
                        .maximum = 1e6,
                        .required = true},
              self.voltage);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] double magnitude() const { return std::abs(voltage); }
};

/// Removes one of the wires that the level states between two objects, named in either order, but no
/// connection by an interaction. Several cuts add up; a cut has no effect if no wire is left.
struct CutWire {
    static constexpr CallText text{"cutWire", "(object, object)",
                                   "Removes one wire that the level states between two conductors; without "
                                   "such a wire it has no effect."};
    static constexpr Algebra algebra = Algebra::sumOfAmounts;
    ObjectId a;
    ObjectId b;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "a", .unit = "", .meaning = "one conductor", .required = true}, self.a);
        visit(FieldInfo{.key = "b", .unit = "", .meaning = "the other conductor", .required = true}, self.b);
    }
    [[nodiscard]] std::array<ObjectId, 2> objects() const { return {a, b}; }
};

/// A fuse melts.
struct BlowFuse {
    static constexpr CallText text{
        "blowFuse", "(object)",
        "Blows a fuse permanently: it loses its connections and accepts no new ones."};
    static constexpr Algebra algebra = Algebra::destroy;
    ObjectId fuse;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "fuse", .unit = "", .meaning = "the fuse", .required = true}, self.fuse);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {fuse}; }
    [[nodiscard]] ObjectId key() const { return fuse; }
};

struct ElectricityRole {
    static constexpr std::string_view name = "Electricity";
    using Calls = CallList<AddConnection, RemoveConnection, HoldConnection, AddVoltage, CutWire, BlowFuse>;
};

} // namespace trembler
