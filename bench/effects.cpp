// The cost of each activated effect: two worlds of the same bodies in perpetual motion, one of which also has
// the effect's properties, alternating in blocks of frames; with two bodies and with a thousand. CPU time of
// this thread, medians of the differences.
#include "puzzle/data/effects.hpp"

#include "audio/effect/hearing/loudness.hpp"
#include "audio/effect/properties/acoustics.hpp"
#include "audio/effect/properties/sounds.hpp"
#include "bench/measure.hpp"
#include "bench/scenes/box2d_scenes.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "physics/magnetism/properties.hpp"
#include "physics/material.hpp"
#include "physics/motor/properties.hpp"
#include "runtime/component/interaction.hpp"
#include "tests/support/initial_wire.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>

namespace {

using namespace trembler;

constexpr double drift = 0.05; // m/s

/// If the world has it, one cable of every circuit is cut or repaired in every frame.
struct CableChanges {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Cable changes", "bench_cable_changes", "A cable to cut and to mend.",
                                       PropertyPlace::hidden};
    ObjectId a;
    ObjectId b;
    bool cut = false; ///< whether the cable is cut now
};

class ElectricityFromBench final
    : public Interaction<ElectricityFromBench, ElectricityRole, Reads<CableChanges>> {
public:
    static constexpr ComponentText text{
        .name = "Electricity <- Bench", .effect = "bench", .level = "", .work = "Cuts and mends."};
    using Activation = NeedsAll<CableChanges>;
    void apply(Access& access) {
        for (CableChanges const& change : access.read<CableChanges>().values()) {
            if (change.cut) {
                access.call(CutWire{change.a, change.b}); // the original cable, or the one that repaired it
                access.call(RemoveConnection{{change.a, change.b}});
            } else {
                access.call(AddConnection{{change.a, change.b}});
            }
        }
    }
};

/// Bodies a metre apart that drift, or balls that bounce on a floor for ever.
class Scene {
public:
    Scene(Registry const& registry, int count, bool bouncing)
        : world_(registry, {.threads = 1, .detail = {}, .periods = {}}), count_(count) {
        Store& store = world_.store();
        settings_ = store.create("world");
        DynamicsSettings solver;
        solver.sleeping = false;
        solver.substeps = 4; // in both worlds; otherwise their number may depend on the effect
        store.column<DynamicsSettings>().set(settings_, solver);
        int const columns = bouncing ? count : static_cast<int>(std::ceil(std::sqrt(count)));
        for (int i = 0; i < count; ++i) {
            ObjectId const id = store.create("body " + std::to_string(i));
            store.column<Shape>().set(id, {{circlePiece(0.1)}});
            store.column<Density>().set(id, {1000});
            if (bouncing) {
                store.column<Position>().set(id, {{1.0 * i, 0.3 + 0.01 * (i % 20)}});
                store.column<Restitution>().set(id, {1});
                store.column<MadeOf>().set(id, {});
            } else {
                int const row = i / columns;
                store.column<Position>().set(id, {{1.0 * (i % columns), 1.0 * row}});
                store.column<Velocity>().set(id, {{drift, 0}});
            }
            bodies_.push_back(id);
        }
        if (bouncing) {
            ObjectId const floor = store.create("floor");
            store.column<Shape>().set(floor, {{boxPiece(count + 2.0, 0.4)}});
            store.column<Position>().set(floor, {{count / 2.0, -0.2}});
            store.column<Fixed>().set(floor, {});
            store.column<GravityField>().set(settings_, {{0, -9.81}});
        }
    }

    void weigh(double acceleration) {
        world_.store().column<GravityField>().set(settings_, {{0, -acceleration}});
    }
    void attract() { world_.store().column<GravityLaw>().set(settings_, {1e-9, 0.01, 0.35}); }
    /// Circuits of ten bodies each, always on.
    void wire() {
        Store& store = world_.store();
        auto const conductor = [&](std::string const& name) {
            ObjectId const id = store.create(name);
            store.column<Conductor>().set(id, {});
            return id;
        };
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            if (i % 10 == 0) {
                std::string const number = std::to_string(i / 10);
                plus_.push_back(conductor("plus " + number));
                ObjectId const minus = conductor("minus " + number);
                store.column<ElectricalSource>().set(plus_.back(), {});
                store.column<ElectricalReturn>().set(minus, {});
                minus_.push_back(minus);
            }
            store.column<Conductor>().set(bodies_[i], {});
            for (ObjectId const pole : {plus_.back(), minus_.back()}) {
                if (auto const fault = connectInitially(store, bodies_[i], pole)) {
                    throw std::logic_error(*fault);
                }
            }
        }
    }
    void resist() {
        for (ObjectId const id : bodies_) {
            world_.store().column<Resistance>().set(id, {10});
        }
    }
    void change() {
        for (std::size_t i = 0; i < plus_.size(); ++i) {
            world_.store().column<CableChanges>().set(plus_[i], {plus_[i], bodies_[10 * i], false});
        }
        changing_ = true;
    }
    void turn() {
        for (ObjectId const id : bodies_) {
            world_.store().column<ElectricMotor>().set(id, {0.01, 10, {}});
        }
    }
    void magnetise() {
        for (ObjectId const id : bodies_) {
            world_.store().column<MagneticStrength>().set(id, {10, 0});
            world_.store().column<MagneticPoles>().set(id, {PoleSet::both, {0.05, 0}, {-0.05, 0}});
        }
    }
    /// All bodies are submerged, except for a row that is half submerged; the liquid drifts with them.
    void flood() {
        Store& store = world_.store();
        ObjectId const sea = store.create("sea");
        double const side = std::ceil(std::sqrt(count_)) + 200;
        store.column<Shape>().set(sea, {{boxPiece(2 * side, side)}});
        store.column<Position>().set(sea, {{0, std::floor(std::sqrt(count_ - 1.0)) - side / 2}});
        store.column<Density>().set(sea, {1000});
        store.column<Liquid>().set(sea, {1.5, 1, {drift, 0}});
    }
    void listen() { listening_.push_back(world_.want<Sounds>()); }
    void microphone() {
        ObjectId const ear = world_.store().create("ear");
        world_.store().column<Position>().set(ear, {{0, 2}});
        world_.store().column<Ear>().set(ear, {});
        listening_.push_back(world_.want<Loudness>());
    }

    void start() { world_.start(); }
    void step() {
        if (changing_) {
            auto& changes = world_.store().column<CableChanges>();
            for (std::size_t i = 0; i < plus_.size(); ++i) {
                changes.set(plus_[i], {plus_[i], bodies_[10 * i], world_.frame() % 2 == 0});
            }
        }
        world_.step();
    }
    [[nodiscard]] World const& world() const { return world_; }

private:
    World world_;
    std::vector<Subscription> listening_;
    int count_;
    ObjectId settings_;
    std::vector<ObjectId> bodies_;
    std::vector<ObjectId> plus_;
    std::vector<ObjectId> minus_;
    bool changing_ = false;
};

struct Case {
    std::string name;
    bool bouncing;
    std::function<void(Scene&)> base; ///< properties of both worlds
    std::function<void(Scene&)> more; ///< additional properties of one world
    /// Part of the title of the measured component, which must have run.
    std::string component;
};

Registry const& effects() {
    static Registry const registry = [] {
        Registry made;
        registerEffects(made);
        made.component<ElectricityFromBench>();
        return made;
    }();
    return registry;
}

std::uint64_t updatesOf(Scene const& scene, std::string const& component) {
    std::uint64_t updates = 0;
    for (ComponentStatus const& status : scene.world().status()) {
        updates += title(*status.info).find(component) == std::string::npos ? 0 : status.updates;
    }
    return updates;
}

struct Cost {
    double base = 0; ///< µs per frame
    double more = 0; ///< µs per frame
};

Cost measure(Case const& one, int count, int repetitions) {
    int const blockFrames = count > 100 ? 10 : 300;
    bench::Series base;
    bench::Series difference;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
        Scene a(effects(), count, one.bouncing);
        Scene b(effects(), count, one.bouncing);
        one.base(a);
        one.base(b);
        one.more(b);
        a.start();
        b.start();
        for (int frame = 0; frame < 60; ++frame) {
            a.step();
            b.step();
        }
        for (int block = 0; block < 30; ++block) {
            double const first = block % 2 == 0 ? bench::timeBlock(a, blockFrames) : 0;
            double const with = bench::timeBlock(b, blockFrames);
            double const without = block % 2 == 0 ? first : bench::timeBlock(a, blockFrames);
            base.add(without);
            difference.add(with - without);
        }
        if (updatesOf(b, one.component) == 0) {
            throw std::logic_error(one.component + " had nothing to do: nothing was measured");
        }
    }
    return {1e6 * base.median(), 1e6 * difference.median()};
}

} // namespace

// bench_effects [repetitions].
int main(int argc, char** argv) {
    int const repetitions = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
    auto const nothing = [](Scene&) {};
    auto const wired = [](Scene& scene) { scene.wire(); };
    auto const heard = [](Scene& scene) { scene.listen(); };
    std::vector<Case> const cases{
        {"linear gravity", false, nothing, [](Scene& scene) { scene.weigh(0.01); }, "Linear Gravity DPS"},
        {"real gravity", false, nothing, [](Scene& scene) { scene.attract(); }, "Real Gravity DPS"},
        {"electricity, two-wire, nothing changes", false, nothing, wired, "Two-wire Electricity DPS"},
        {"electricity, two-wire, every circuit changes in every frame", false, nothing,
         [](Scene& scene) {
             scene.wire();
             scene.change();
         },
         "Two-wire Electricity DPS"},
        {"electricity, nodal, every circuit changes in every frame", false, nothing,
         [](Scene& scene) {
             scene.wire();
             scene.resist();
             scene.change();
         },
         "Nodal Electricity DPS"},
        {"motors (beside the electricity that they need)", false, wired, [](Scene& scene) { scene.turn(); },
         "(Dynamics <- Electricity) Interaction"},
        {"magnetism, pairwise", false, nothing, [](Scene& scene) { scene.magnetise(); },
         "Magnetic Forces DPS"},
        {"buoyancy and drag (beside gravity)", false, [](Scene& scene) { scene.weigh(0.01); },
         [](Scene& scene) { scene.flood(); }, "Buoyancy Resolver"},
        {"sound", true, nothing, heard, "(Sound <- Dynamics) Interaction"},
        {"loudness at one ear (beside sound)", true, heard, [](Scene& scene) { scene.microphone(); },
         "Loudness"},
    };
    bench::Table table("What effects add to a frame, every body called on");
    for (Case const& one : cases) {
        Cost const two = measure(one, 2, repetitions);
        Cost const thousand = measure(one, 1000, repetitions);
        table.row(one.name + ": 2 bodies", two.more, fmt::format("us, beside {:.1f}", two.base));
        table.row(one.name + ": 1000 bodies", thousand.more, fmt::format("us, beside {:.1f}", thousand.base));
    }
    table.print();
    return 0;
}
