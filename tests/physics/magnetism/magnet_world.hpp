// Worlds of magnets for tests, without dynamics: objects stay in place.
#pragma once

#include "physics/dynamics/properties/standstill.hpp"
#include "physics/magnetism/calls.hpp"
#include "physics/magnetism/magnetic_forces.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/magnetism/register.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/property/for_each.hpp"
#include "runtime/world/world.hpp"

#include <string>

namespace trembler::test {

/// A switch of an electromagnet that the test operates, instead of electricity.
struct Switch {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Switch", "test_switch", "Whether the magnet is kept on, for tests."};
    bool on = false;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "", .meaning = "on"}, self.on);
    }
};

struct MagneticsFromSwitch final : Interaction<MagneticsFromSwitch, MagneticsRole, Reads<Switch>> {
    static constexpr ComponentText text{.name = "Magnetics <- Switch",
                                        .effect = "test",
                                        .level = "",
                                        .work = "Keeps on what is switched on."};
    using Activation = NeedsAll<Switch>;
    void apply(Access& access) {
        forEach(
            [&](ObjectId id, Switch const& s) {
                if (s.on) {
                    access.call(EnableMagnet{id});
                }
            },
            access.read<Switch>());
    }
};

inline Registry const& magnetRules() {
    static Registry const registry = [] {
        Registry made;
        registerRuntime(made);
        registerMagnetism(made);
        made.component<MagneticsFromSwitch>();
        made.component<Standstill>();
        return made;
    }();
    return registry;
}

class MagnetWorld {
public:
    explicit MagnetWorld(int threads = 1)
        : world(magnetRules(), {.threads = threads, .detail = {}, .periods = {}}) {}

    ObjectId magnet(Vec2 at, double angle, double strength, MagneticPoles poles, double susceptibility = 0) {
        ObjectId const id = thing(at, angle, strength, susceptibility);
        world.store().column<MagneticPoles>().set(id, poles);
        return id;
    }
    /// An object that magnets attract, without poles of its own.
    ObjectId soft(Vec2 at, double susceptibility) { return thing(at, 0, 0, susceptibility); }
    ObjectId electromagnet(Vec2 at, int coolDown) {
        ObjectId const id = magnet(at, 0, 100, {PoleSet::both, {0, 0.1}, {0, -0.1}});
        world.store().column<Electromagnet>().set(id, {coolDown});
        world.store().column<Switch>().set(id, {false});
        return id;
    }
    void run(int frames) {
        if (!started_) {
            world.start();
            started_ = true;
        }
        for (int i = 0; i < frames; ++i) {
            world.step();
        }
    }
    [[nodiscard]] std::vector<MagneticForce::Entry> const& forces() const {
        return world.find<MagneticForce>()->forces;
    }
    /// The force in N, summed over all poles and the centre of an object.
    [[nodiscard]] Vec2 force(ObjectId id) const {
        Vec2 sum;
        for (MagneticForce::Entry const& entry : forces()) {
            if (entry.object == id) {
                sum += entry.force;
            }
        }
        return sum;
    }

    World world;

private:
    ObjectId thing(Vec2 at, double angle, double strength, double susceptibility) {
        Store& store = world.store();
        ObjectId const id = store.create("thing " + std::to_string(store.objects().size()));
        store.column<Position>().set(id, {at});
        store.column<Rotation>().set(id, {angle});
        store.column<MagneticStrength>().set(id, {strength, susceptibility});
        return id;
    }
    bool started_ = false;
};

/// Poles at both ends of a bar along its x axis, north first, `length` m apart.
inline MagneticPoles barPoles(double length) {
    return {PoleSet::both, {length / 2, 0}, {-length / 2, 0}};
}

} // namespace trembler::test
