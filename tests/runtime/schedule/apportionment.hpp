// The resolvers of 6.13 with exactly the sets of its boxes and without implementation: for tests of the
// schedule and the notation. The names are the thesis's.
#pragma once

#include "runtime/component/dps.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/component/resolver.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/registry.hpp"

#include <array>

namespace trembler::apportionment {

// A property without fields is enough: only its name counts here.
#define TREMBLER_TEST_PROPERTY(Type, propertyKind, name, key)                                                \
    struct Type {                                                                                            \
        static constexpr PropertyKind kind = PropertyKind::propertyKind;                                     \
        static constexpr PropertyText text{name, key, "As in 6.13.1."};                                      \
        static constexpr Coverage coverage = hashed;                                                         \
        static constexpr std::string_view standing = "empty";                                                \
    }
TREMBLER_TEST_PROPERTY(Mass, object, "Mass", "mass");
TREMBLER_TEST_PROPERTY(Shape, object, "Shape", "shape");
TREMBLER_TEST_PROPERTY(Density, object, "Density", "density");
TREMBLER_TEST_PROPERTY(Liquid, object, "Liquid", "liquid");
TREMBLER_TEST_PROPERTY(Conductor, object, "Conductor", "conductor");
TREMBLER_TEST_PROPERTY(ElectricityGraph, object, "G_E", "electricity_graph");
TREMBLER_TEST_PROPERTY(MagneticStrength, object, "Magnetic strength", "magnetic_strength");
TREMBLER_TEST_PROPERTY(MagneticPoles, object, "Magnetic poles", "magnetic_poles");
TREMBLER_TEST_PROPERTY(MagnetOn, object, "Magnet on/off", "magnet");
TREMBLER_TEST_PROPERTY(Electromagnet, object, "Is an electromagnet", "electromagnet");
TREMBLER_TEST_PROPERTY(Contacts, resolver, "C_C, C_N, C_P", "contacts");
TREMBLER_TEST_PROPERTY(BuoyantForce, resolver, "F_B", "buoyant_force");
TREMBLER_TEST_PROPERTY(BuoyancyCentre, resolver, "Centre of Buoyancy", "centre_of_buoyancy");
TREMBLER_TEST_PROPERTY(LinearGravityVector, resolver, "Linear gravity vector", "linear_gravity_vector");
TREMBLER_TEST_PROPERTY(ElectricalState, derived, "Electrical state", "electrical_state");
TREMBLER_TEST_PROPERTY(MagneticForce, derived, "F_M", "magnetic_force");
TREMBLER_TEST_PROPERTY(GravityForce, derived, "F_G", "gravity_force");
#undef TREMBLER_TEST_PROPERTY

struct AddForceToPoint {
    static constexpr CallText text{"addForceToPoint", "(object, point, force)",
                                   "Adds the specified force to the object at the specified point."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    ObjectId object;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};
struct ChangeConnection {
    static constexpr CallText text{
        "addConnection / removeConnection", "(object, object)",
        "Adds or removes a connection between two conductors in the electricity graph."};
    static constexpr Algebra algebra = Algebra::countedSet;
    ObjectId a;
    ObjectId b;
    int change = 1;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "a", .unit = "", .meaning = "one", .required = true}, self.a);
        visit(FieldInfo{.key = "b", .unit = "", .meaning = "the other", .required = true}, self.b);
        visit(FieldInfo{.key = "change", .unit = "", .meaning = "how often", .required = true}, self.change);
    }
    [[nodiscard]] std::array<ObjectId, 2> objects() const { return {a, b}; }
    [[nodiscard]] std::pair<ObjectId, ObjectId> key() const { return {a, b}; }
    [[nodiscard]] int delta() const { return change; }
};
struct EnableMagnet {
    static constexpr CallText text{"enableMagnet / disableMagnet", "(object)",
                                   "Sets the on/off flag for the specified object."};
    static constexpr Algebra algebra = Algebra::anyOf;
    ObjectId object;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true}, self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
    [[nodiscard]] ObjectId key() const { return object; }
};
struct SetLinearGravity {
    static constexpr CallText text{"setLinearGravity", "(vector)", "Defines the linear gravity vector."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    Vec2 vector;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "vector", .unit = "m/s²", .meaning = "acceleration", .required = true},
              self.vector);
    }
    [[nodiscard]] std::array<ObjectId, 0> objects() const { return {}; }
};

#define TREMBLER_TEST_ROLE(Type, roleName, ...)                                                              \
    struct Type {                                                                                            \
        static constexpr std::string_view name = roleName;                                                   \
        using Calls = CallList<__VA_ARGS__>;                                                                 \
    }
TREMBLER_TEST_ROLE(DynamicsRole, "Dynamics", AddForceToPoint);
TREMBLER_TEST_ROLE(ElectricityRole, "Electricity", ChangeConnection);
TREMBLER_TEST_ROLE(MagneticsRole, "Magnetics", EnableMagnet);
TREMBLER_TEST_ROLE(BuoyancyRole, "Buoyancy", SetLinearGravity);
#undef TREMBLER_TEST_ROLE

// 6.13.2
struct Dynamics final : Resolver<Dynamics, DynamicsRole,
                                 Reads<Position, Velocity, AngularVelocity, Rotation, Shape, Mass, Liquid>,
                                 Writes<Position, Velocity, AngularVelocity, Rotation>, Provides<Contacts>> {
    static constexpr ComponentText text{
        .name = "Dynamics",
        .effect = "dynamics",
        .level = "",
        .work = "Performs both collision detection and rigid body simulation. The 'Liquid' property is read "
                "so that "
                "collision detection is not performed between liquid and solid objects."};
    using Activation = NeedsAll<Position, Shape>;
    void advance(Access&) {}
};
struct Electricity final
    : Resolver<Electricity, ElectricityRole, Reads<ElectricityGraph>, Writes<ElectricityGraph>> {
    static constexpr ComponentText text{.name = "Electricity",
                                        .effect = "electricity",
                                        .level = "",
                                        .work = "Manipulate the electricity graph as instructed."};
    using Activation = NeedsAny<Conductor>;
    void advance(Access&) {}
};
struct Magnetics final : Resolver<Magnetics, MagneticsRole, Reads<>, Writes<MagnetOn>> {
    static constexpr ComponentText text{
        .name = "Magnetics",
        .effect = "magnetism",
        .level = "",
        .work = "Change the properties as requested by the interaction functions."};
    using Activation = NeedsAny<MagneticPoles>;
    void advance(Access&) {}
};
struct Buoyancy final : Resolver<Buoyancy, BuoyancyRole, Reads<Position, Rotation, Shape, Density, Liquid>,
                                 Writes<>, Provides<LinearGravityVector, BuoyantForce, BuoyancyCentre>> {
    static constexpr ComponentText text{.name = "Buoyancy",
                                        .effect = "buoyancy",
                                        .level = "",
                                        .work = "Calculate the centre of buoyancy and F_B."};
    using Activation = NeedsAll<Liquid>;
    void advance(Access&) {}
};

// 6.13.3
struct ElectricityState final : Dps<ElectricityState, Reads<ElectricityGraph>, Derives<ElectricalState>> {
    static constexpr ComponentText text{
        .name = "Electricity", .effect = "electricity", .level = "two-wire", .work = "On or off."};
    using Activation = NeedsAny<Conductor>;
    void update(Access&) {}
};
struct MagneticForces final
    : Dps<MagneticForces, Reads<Position, Rotation, MagneticPoles, MagneticStrength, MagnetOn>,
          Derives<MagneticForce>> {
    static constexpr ComponentText text{
        .name = "Magnetic Forces", .effect = "magnetism", .level = "", .work = "For each pair of magnets."};
    using Activation = NeedsAny<MagneticPoles>;
    void update(Access&) {}
};
struct LinearGravity final : Dps<LinearGravity, Reads<>, Derives<GravityForce>> {
    static constexpr ComponentText text{
        .name = "Linear Gravity", .effect = "gravity", .level = "linear", .work = "A force for each object."};
    using Activation = NeedsAny<Mass>;
    void update(Access&) {}
};
struct RealGravity final : Dps<RealGravity, Reads<Position, Mass>, Derives<GravityForce>> {
    static constexpr ComponentText text{.name = "Real Gravity",
                                        .effect = "gravity",
                                        .level = "real",
                                        .work = "A force for each object.",
                                        .rank = 1};
    using Activation = NeedsAny<Mass>;
    void update(Access&) {}
};

// 6.13.4
struct DynamicsFromGravity final
    : Interaction<DynamicsFromGravity, DynamicsRole, Reads<Position, GravityForce>> {
    static constexpr ComponentText text{.name = "Dynamics <- Gravity",
                                        .effect = "gravity",
                                        .level = "",
                                        .work = "Applies the force due to gravity."};
    using Activation = NeedsAll<>;
    void apply(Access&) {}
};
struct ElectricityFromDynamics final
    : Interaction<ElectricityFromDynamics, ElectricityRole, Reads<Contacts, Conductor>> {
    static constexpr ComponentText text{.name = "Electricity <- Dynamics",
                                        .effect = "electricity",
                                        .level = "",
                                        .work = "Connects any new colliding objects."};
    using Activation = NeedsAll<>;
    void apply(Access&) {}
};

inline void registerApportionment(Registry& registry) {
    registry.component<Dynamics>();
    registry.component<Electricity>();
    registry.component<Magnetics>();
    registry.component<Buoyancy>();
    registry.component<ElectricityState>();
    registry.component<MagneticForces>();
    registry.component<LinearGravity>();
    registry.component<RealGravity>();
    registry.component<DynamicsFromGravity>();
    registry.component<ElectricityFromDynamics>();
}

} // namespace trembler::apportionment
