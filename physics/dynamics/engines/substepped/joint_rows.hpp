// Joints as constraint rows: each row prescribes the rate of a point or angle, and limits its impulse. For
// engines whose own joints differ from ours.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <optional>

namespace trembler {

/// The state of a body in a joint. The world and fixed bodies have inverse masses of 0.
struct JointPose {
    Vec2 centre;               ///< m, centre of mass
    double angle = 0;          ///< rad
    double inverseMass = 0;    ///< 1/kg
    double inverseInertia = 0; ///< 1/(kg m²)
    Vec2 velocity{};           ///< m/s; only JointRow::bend depends on it
    double spin = 0;           ///< rad/s, likewise
};

/// The Jacobian of a row for one body.
struct RowTerm {
    int body = 0; ///< index into JointRows::slots()
    Vec2 linear;
    double angular = 0;
};

/// Solves J v = speed - softness * impulse, with an impulse between low and high; and corrects position
/// errors with J v' = correction, where v' is a velocity that moves bodies for one step and is then discarded
/// (split impulses, which add no energy).
struct JointRow {
    std::array<RowTerm, 4> terms;
    int count = 0;
    bool corrects = false; ///< whether the row corrects position errors
    double error = 0; ///< m or rad, whose rate is J v: of a rigid row to be 0, of a limit not to be negative
    double bend = 0;  ///< m/s² or rad/s²: what J v grows by if no body accelerates
    double speed = 0; ///< m/s or rad/s
    double softness = 0;   ///< of a spring, 1/kg or 1/(kg m²)
    double pull = 0;       ///< N or N m, of a spring that acts as a force
    double damping = 0;    ///< N s/m, of such a spring; its row has it, too
    double correction = 0; ///< m/s or rad/s
    double low = 0;        ///< N s or N m s
    double high = 0;
    double mass = 0;    ///< 1 / (J M⁻¹ Jᵀ + softness); 0: the row is inactive
    double stiff = 0;   ///< 1 / (J M⁻¹ Jᵀ)
    double impulse = 0; ///< sum in this step; kept to warm-start the next one
    double push = 0;    ///< the same for the correction

    /// Whether it must hold exactly, unlike motors, which are limited, and springs, which yield.
    [[nodiscard]] bool exact() const { return softness == 0 && (rigid() || limit()); }
    [[nodiscard]] bool rigid() const { return low < 0 && corrects; }
    [[nodiscard]] bool limit() const { return low == 0 && high > 0; }

    /// Returns the change of the impulse that brings the row to its target, given `relative` = J v.
    [[nodiscard]] double solve(double relative);
    /// The same for the correction, given `relative` = J v'.
    [[nodiscard]] double solveCorrection(double relative);
};

/// One joint of any form. Formulas: Jacobians by differentiating the constraint; springs by implicit Euler
/// (E. Catto, Soft Constraints, GDC 2011); limits are speculative, so that a body may just reach them.
class JointRows {
public:
    /// A gear needs the two joints that it couples; other forms none.
    explicit JointRows(JointSpec const& spec, JointRows const* first = nullptr,
                       JointRows const* second = nullptr);

    /// The bodies that rows refer to; noSlot means the world. The first is the joint's a.
    [[nodiscard]] std::span<SlotIndex const> slots() const {
        return {slots_.data(), static_cast<std::size_t>(bodies_)};
    }
    /// Computes the rows for a substep of `h` (s) from the bodies' poses (in the order of slots()). Impulses
    /// are kept. A spring that swings by up to `widestSwing` rad in a substep acts as a force, its row only
    /// damps it.
    void prepare(std::span<JointPose const> poses, double h, double widestSwing = 0);
    [[nodiscard]] std::span<JointRow> rows() { return {rows_.data(), static_cast<std::size_t>(count_)}; }
    /// The impulse (N s) on a within this step, with that of springs which act as forces for `h` (s).
    [[nodiscard]] Vec2 impulseOnA(double h = 0) const;
    /// The impulses of all rows, as they are kept for the next step.
    [[nodiscard]] std::array<double, 5> impulses() const;
    void setImpulses(std::array<double, 5> const& impulses);
    /// Whether the joint has a motor that must not fall asleep.
    [[nodiscard]] bool restless() const;
    [[nodiscard]] JointForm form() const { return joint_.form; }

private:
    /// A quantity that a gear couples: an angle or a displacement of a relative to b, and its rate.
    struct Coordinate {
        double value = 0;
        std::array<RowTerm, 2> terms;
        double bend = 0; ///< acceleration of the value if no body accelerates
    };
    struct Ends;

    int bodyOf(SlotIndex slot);
    [[nodiscard]] Ends endsOf(std::span<JointPose const> poses) const;
    [[nodiscard]] Coordinate turn(Ends const& ends) const;
    [[nodiscard]] Coordinate shift(Ends const& ends, Vec2 direction) const;
    [[nodiscard]] Coordinate coordinate(std::span<JointPose const> poses) const;
    [[nodiscard]] Coordinate distance(Ends const& ends) const;
    JointRow& row(Coordinate const& along, double scale = 1);
    void rigid(Coordinate const& along, double error);
    void pin(Ends const& ends);
    void drive(Coordinate const& along);
    void limit(Coordinate const& along);
    void taut(Coordinate const& along, double slack);
    void spring(Coordinate const& along, double error, std::span<JointPose const> poses);
    void preparePulley(Ends const& ends);
    void prepareGear(std::span<JointPose const> poses);

    Joint joint_;
    JointAnchors anchors_; // relative to the centres of mass
    std::array<SlotIndex, 4> slots_{};
    int bodies_ = 0;
    int a_ = 0;
    int b_ = 0;
    double h_ = 0;
    double widestSwing_ = 0; // rad
    std::array<JointRow, 5> rows_;
    int count_ = 0;
    std::vector<JointRows> coupled_;   // of a gear
    std::optional<double> constant_{}; // of a gear: the weighted sum of its coordinates when it was created
};

} // namespace trembler
