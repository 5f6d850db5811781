// Worlds for the hard cases: bodies and joints, and measurements on them. Every world is jittered by a seed,
// so that no result depends on perfect symmetry.
#pragma once

#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/joint.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "runtime/world/world.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace trembler::stability {

inline constexpr int second = 60;         ///< frames
inline constexpr double g = earthGravity; ///< m/s², of a Rig unless it is given another gravity

/// How to run a case.
struct Setting {
    DynamicsSettings solver = {}; ///< each case sets `sleeping` itself
    std::string engine = "box2d";
    int threads = 1;
};

/// Numbers between -1 and 1 that depend on a seed alone, the same on every machine (SplitMix64).
class Jitter {
public:
    explicit Jitter(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15U) {}
    double operator()();

private:
    std::uint64_t state_;
};

class Rig {
public:
    /// With gravity of 9.81 m/s² downwards by default, and sleeping off.
    Rig(Setting const& setting, std::uint64_t seed, Vec2 gravity = {0, -g});

    ObjectId body(ShapePiece piece, Vec2 at, double mass, double angle = 0);
    ObjectId fixed(ShapePiece piece, Vec2 at, double angle = 0);
    /// Joins `a` to `b`, or to the world if `b` is invalid. The joint's gap is included in worstGap().
    ObjectId tie(JointForm form, ObjectId a, ObjectId b, Vec2 at);
    template <class P>
    void give(ObjectId id, P property) {
        world->store().column<P>().set(id, std::move(property));
    }
    /// Starts the world if needed and computes one frame.
    void step();
    void start();

    [[nodiscard]] Vec2 at(ObjectId id) const;
    [[nodiscard]] Vec2 velocity(ObjectId id) const;
    [[nodiscard]] double angle(ObjectId id) const;
    /// All bodies made by body().
    [[nodiscard]] std::vector<ObjectId> const& bodies() const { return bodies_; }
    /// The largest displacement of any body from its initial place, m.
    [[nodiscard]] double drift() const;
    /// The same, along x only.
    [[nodiscard]] double sidewaysDrift() const;
    /// The largest speed of any body, m/s.
    [[nodiscard]] double fastest() const;
    /// The widest gap of any joint, m.
    [[nodiscard]] double worstGap() const;
    /// Whether all positions and velocities are finite.
    [[nodiscard]] bool finite() const;

    Jitter jitter;
    std::unique_ptr<World> world;

private:
    struct Tie {
        ObjectId a;
        ObjectId b;
        Vec2 onA;
        Vec2 onB;
    };
    [[nodiscard]] Vec2 toBody(ObjectId id, Vec2 point) const;
    [[nodiscard]] Vec2 toWorld(ObjectId id, Vec2 point) const;

    std::vector<ObjectId> bodies_;
    std::vector<Vec2> places_;
    std::vector<Tie> ties_;
    int count_ = 0;
    bool started_ = false;
};

} // namespace trembler::stability
