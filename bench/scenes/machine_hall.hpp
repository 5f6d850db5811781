// A hall of machines that never rest, of any size: the scene for measuring the gain from threads. Each
// machine has a pool with driftwood and a paddle, a drum in which loose objects tumble, and a motor that
// closes a contact once per turn, so that an electromagnet attracts iron balls. Nothing in it is scripted. If
// there are listeners, the noise switches lamps.
#pragma once

#include "audio/effect/properties/acoustics.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/material.hpp"
#include "physics/motor/properties.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/store.hpp"
#include "tests/support/initial_wire.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

using namespace trembler;

/// Builds the hall in an empty store.
class MachineHall {
public:
    explicit MachineHall(Store& store) : store_(store) {}

    /// Builds that number of machines, `listeners` of them with a lamp that is switched by sound, and loose
    /// objects in their drums until there are `objects` objects.
    void build(int machines, std::size_t objects, int listeners) {
        store_.column<GravityField>().set(store_.create("world"), {{0, -9.81}});
        for (int i = 0; i < machines; ++i) {
            prefix_ = fmt::format("machine {:02} ", i);
            origin_ = {pitch * i, 0};
            plus_ = conductor("plus");
            minus_ = conductor("minus");
            store_.column<ElectricalSource>().set(plus_, {});
            store_.column<ElectricalReturn>().set(minus_, {});
            fixed("floor", Material::stone, boxPiece(pitch, 0.4), {0, -0.2});
            pool();
            magnet();
            drum();
            if (i * listeners / machines != (i + 1) * listeners / machines) {
                listener();
            }
        }
        for (int n = 0; store_.objects().size() < objects; ++n) {
            int const machine = n % machines;
            prefix_ = fmt::format("machine {:02} ", machine);
            origin_ = {pitch * machine, 0};
            loose(n / machines);
        }
    }

private:
    static constexpr double pitch = 12; // m

    ObjectId thing(std::string const& name) { return store_.create(prefix_ + name); }
    ObjectId conductor(std::string const& name) {
        ObjectId const id = thing(name);
        store_.column<Conductor>().set(id, {});
        return id;
    }
    ObjectId body(std::string const& name, Material material, std::vector<ShapePiece> pieces, Vec2 at) {
        ObjectId const id = thing(name);
        store_.column<Shape>().set(id, {std::move(pieces)});
        store_.column<Position>().set(id, {origin_ + at});
        store_.column<MadeOf>().set(id, {material});
        return id;
    }
    ObjectId fixed(std::string const& name, Material material, ShapePiece const& piece, Vec2 at) {
        ObjectId const id = body(name, material, {piece}, at);
        store_.column<Fixed>().set(id, {});
        return id;
    }
    void hinge(ObjectId id, Vec2 at, std::string const& name) {
        Joint joint;
        joint.a = id;
        joint.at = origin_ + at;
        store_.column<Joint>().set(thing(name), joint);
    }
    void wire(ObjectId a, ObjectId b) {
        if (auto const fault = connectInitially(store_, a, b)) {
            throw std::logic_error(*fault);
        }
    }
    /// Turns as long as it has electricity, which is always.
    void motor(ObjectId id, double torque, double speed) {
        store_.column<Conductor>().set(id, {});
        store_.column<ElectricMotor>().set(id, {torque, speed, {}});
        wire(plus_, id);
        wire(id, minus_);
    }

    void pool() {
        fixed("left wall", Material::stone, boxPiece(0.2, 1.6), {-5.6, 0.8});
        fixed("right wall", Material::stone, boxPiece(0.2, 1.6), {-1.4, 0.8});
        ObjectId const water = body("water", Material::water, {boxPiece(4, 1.2)}, {-3.5, 0.6});
        store_.column<Liquid>().set(water, {});
        Vec2 const axis{-3.5, 1.1};
        ObjectId const paddle = body("paddle", Material::steel, {boxPiece(1.6, 0.12)}, axis);
        hinge(paddle, axis, "paddle's axis");
        motor(paddle, 60, 4);
        for (int i = 0; i < 12; ++i) {
            ObjectId const log = body(fmt::format("driftwood {:02}", i), Material::wood,
                                      {boxPiece(0.3, 0.18 + 0.02 * (i % 4))},
                                      {-5.2 + 0.35 * (i % 6) + (i % 6 > 2 ? 1.6 : 0), 1.5 + 0.4 * (i / 6)});
            store_.column<Density>().set(log, {500});
        }
    }

    void magnet() {
        Vec2 const axis{0, 1.6};
        ObjectId const rotor = body("rotor", Material::copper, {boxPiece(1, 0.1)}, axis);
        hinge(rotor, axis, "rotor's axis");
        motor(rotor, 40, 6);
        ObjectId const flap = body("flap", Material::copper, {boxPiece(0.06, 0.8)}, {0.48, 1.6});
        hinge(flap, {0.48, 2.0}, "flap's hinge");
        store_.column<Conductor>().set(flap, {});
        store_.column<Damping>().set(flap, {0, 1});
        ObjectId const coil = fixed("electromagnet", Material::iron, boxPiece(0.4, 0.3), {1.9, 1.3});
        store_.column<Conductor>().set(coil, {});
        store_.column<Electromagnet>().set(coil, {});
        store_.column<Magnet>().set(coil, {false, 0});
        store_.column<MagneticStrength>().set(coil, {60000, 0});
        store_.column<MagneticPoles>().set(coil, {PoleSet::south, {}, {0, -0.15}});
        wire(flap, coil);
        wire(coil, minus_);
        for (int i = 0; i < 3; ++i) {
            ObjectId const ball = body(fmt::format("iron ball {}", i), Material::iron, {circlePiece(0.12)},
                                       {1.6 + 0.3 * i, 0.12});
            store_.column<Conductor>().set(ball, {});
            store_.column<MagneticStrength>().set(ball, {0, 40000});
        }
    }

    void drum() {
        constexpr int sides = 10;
        std::vector<ShapePiece> rim;
        for (int i = 0; i < sides; ++i) {
            double const angle = 2 * pi * i / sides;
            rim.push_back(boxPiece(0.1, 0.82, rotated({1.15, 0}, angle), angle));
        }
        ObjectId const id = body("drum", Material::steel, rim, drumAxis);
        hinge(id, drumAxis, "drum's axis");
        motor(id, 3000, 2.2);
    }

    void listener() {
        ObjectId const lamp = conductor("lamp");
        wire(lamp, minus_);
        ObjectId const ear = thing("microphone");
        store_.column<Position>().set(ear, {origin_ + Vec2{3.5, 3.5}});
        store_.column<SoundSensor>().set(ear, {75, plus_, lamp});
    }

    /// The nth loose object in a drum: balls, boxes and magnets of many materials.
    void loose(int n) {
        constexpr std::array<Material, 6> materials{Material::steel, Material::wood,   Material::glass,
                                                    Material::iron,  Material::rubber, Material::copper};
        auto const kind = static_cast<std::size_t>(n) % materials.size();
        Vec2 const at = drumAxis + Vec2{-0.55 + 0.28 * (n % 5), -0.55 + 0.28 * (n / 5)};
        bool const round = n % 2 == 0;
        double const size = 0.16 + 0.015 * (n % 4);
        ObjectId const id = body(fmt::format("loose {:03}", n), materials[kind],
                                 {round ? circlePiece(size / 2) : boxPiece(size, size)}, at);
        bool const metal = materials[kind] == Material::steel || materials[kind] == Material::iron ||
                           materials[kind] == Material::copper;
        if (metal) {
            store_.column<Conductor>().set(id, {});
        }
        if (materials[kind] == Material::iron) {
            store_.column<MagneticStrength>().set(id, {0, 400});
        }
        if (materials[kind] == Material::steel) {
            store_.column<MagneticStrength>().set(id, {400, 400});
            store_.column<Magnet>().set(id, {});
            store_.column<MagneticPoles>().set(id, {PoleSet::both, {size / 4, 0}, {-size / 4, 0}});
        }
    }

    static constexpr Vec2 drumAxis{4.2, 1.6};

    Store& store_;
    std::string prefix_;
    Vec2 origin_;
    ObjectId plus_;
    ObjectId minus_;
};

} // namespace bench
