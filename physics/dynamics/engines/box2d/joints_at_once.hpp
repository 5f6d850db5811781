// Solves the joints of a Box2D world simultaneously, as one system of equations, before each step.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <box2d/box2d.h>

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace trembler {

/// Box2D solves one joint after the other, repeatedly. The number of iterations until a tension has
/// propagated through a chain is about the square of the number of its links, and grows with the load at its
/// end: the missing part of the tension makes the chain oscillate. Here the impulses that keep all hinges,
/// welds and rigid distances together in the coming step are computed exactly, from J M⁻¹ Jᵀ λ = -J (v + h
/// M⁻¹ f) (Baraff 1996), by a sparse LDLᵀ factorisation whose symbolic part is kept. They are applied to the
/// bodies before the step; Box2D's own joints then only handle contacts, limits and motors, and correct
/// positions.
///
/// Redundant joints share their load through a regularisation of 1e-12. Deterministic. If joints form a net
/// rather than chains, trees and rings, the factorisation would cost more than it saves, and solve() does
/// nothing.
class JointsAtOnce {
public:
    struct Pull {
        b2Vec2 force;
        float torque;
    };

    JointsAtOnce();
    ~JointsAtOnce();
    JointsAtOnce(JointsAtOnce const&) = delete;
    JointsAtOnce& operator=(JointsAtOnce const&) = delete;

    /// Sets the joints of the world, by slot; nullptr for a free slot. Call before the next solve() whenever
    /// joints have been added or removed.
    void setJoints(std::span<b2Joint* const> joints);
    /// Applies the impulses for a step of `h` (s) to the bodies; `pullOn` returns the external force and
    /// torque on a body in that step.
    void solve(float h, std::function<Pull(b2Body const&)> const& pullOn);
    /// The impulse of a joint in the last solve(), in the engine's units, on its Box2D body B.
    [[nodiscard]] b2Vec2 impulse(SlotIndex slot) const {
        return slot < impulses_.size() ? impulses_[slot] : b2Vec2_zero;
    }

private:
    struct Factor;
    struct Mover {
        b2Body* body = nullptr;
        double inverseMass = 0; // multiplied by the share of an impulse that damping leaves
        double inverseInertia = 0;
        double vx = 0; // velocity after the step without any joint
        double vy = 0;
        double spin = 0;
        double px = 0; // sum of the impulses
        double py = 0;
        double turn = 0;
        std::vector<std::pair<std::size_t, double>> rows; // the rows that involve it, with their signs
    };
    // n (v_B - v_A) + tb ω_B - ta ω_A = 0
    struct Row {
        double nx = 0;
        double ny = 0;
        double ta = 0;
        double tb = 0;
    };
    struct Tie {
        b2Joint* joint = nullptr;
        SlotIndex slot = noSlot;
        std::size_t a = 0; // index of a mover; none: fixed
        std::size_t b = 0;
        std::size_t firstRow = 0;
        std::size_t rows = 0;
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void findStructure();
    [[nodiscard]] bool pairsExceed(std::size_t most) const;
    void look(float h, std::function<Pull(b2Body const&)> const& pullOn);
    void setRows(Tie const& tie);
    [[nodiscard]] bool factorise();
    void give();

    std::unique_ptr<Factor> factor_;
    std::vector<Mover> movers_;
    std::vector<Tie> ties_;
    std::vector<Row> rows_;
    std::vector<b2Vec2> impulses_; // by slot
    bool tooDense_ = false;
};

} // namespace trembler
