// Joints as rows: each says how fast some point or angle may change, and with which impulse at most. For
// engines whose own joints are others than ours.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <optional>

namespace trembler {

/// A body as a joint sees it. The world, and a fixed body, has no inverse mass.
struct JointPose {
    Vec2 centre;               ///< m, of mass
    double angle = 0;          ///< rad
    double inverseMass = 0;    ///< 1/kg
    double inverseInertia = 0; ///< 1/(kg m²)
};

/// The part of a row for one body: the Jacobian's.
struct RowTerm {
    int body = 0; ///< index into JointRows::slots()
    Vec2 linear;
    double angular = 0;
};

/// Wants J v = speed - softness * impulse, with an impulse between low and high; and that errors of place
/// vanish with J v' = correction, v' a velocity that moves bodies for one step and is then forgotten (split
/// impulses, which add no energy).
struct JointRow {
    std::array<RowTerm, 4> terms;
    int count = 0;
    bool corrects = false; ///< whether errors of place are its business
    double speed = 0;      ///< m/s or rad/s
    double softness = 0;   ///< of a spring, 1/kg or 1/(kg m²)
    double correction = 0; ///< m/s or rad/s
    double low = 0;        ///< N s or N m s
    double high = 0;
    double mass = 0;    ///< 1 / (J M⁻¹ Jᵀ + softness); 0: the row rests
    double stiff = 0;   ///< 1 / (J M⁻¹ Jᵀ)
    double impulse = 0; ///< so far in this step; kept to start the next with
    double push = 0;    ///< the same for the correction

    /// The change of the impulse that brings the row to its target, given J v.
    [[nodiscard]] double solve(double relative);
    /// The same for the correction, given J v'.
    [[nodiscard]] double solveCorrection(double relative);
};

/// One joint of any form. Formulas: Jacobians by differentiating the constraint; springs by implicit Euler
/// (E. Catto, Soft Constraints, GDC 2011); limits speculatively, so that a body may just reach them.
class JointRows {
public:
    /// A gear needs the joints that it couples; others none.
    explicit JointRows(JointSpec const& spec, JointRows const* first = nullptr,
                       JointRows const* second = nullptr);

    /// The bodies that rows refer to; noSlot stands for the world. The first is the joint's a.
    [[nodiscard]] std::span<SlotIndex const> slots() const {
        return {slots_.data(), static_cast<std::size_t>(bodies_)};
    }
    /// Works out the rows for a substep of `h` (s) from where the bodies (as in slots()) are. Impulses stay.
    void prepare(std::span<JointPose const> poses, double h);
    [[nodiscard]] std::span<JointRow> rows() { return {rows_.data(), static_cast<std::size_t>(count_)}; }
    /// The impulse (N s) on a within this step.
    [[nodiscard]] Vec2 impulseOnA() const;
    /// Its motor must not fall asleep.
    [[nodiscard]] bool restless() const;
    [[nodiscard]] JointForm form() const { return joint_.form; }

private:
    /// A quantity that a gear couples: an angle or a shift of a as seen from b, and how it changes.
    struct Coordinate {
        double value = 0;
        std::array<RowTerm, 2> terms;
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
    void spring(Coordinate const& along, double error);
    void preparePulley(Ends const& ends);
    void prepareGear(std::span<JointPose const> poses);

    Joint joint_;
    JointAnchors anchors_; // relative to centres of mass
    std::array<SlotIndex, 4> slots_{};
    int bodies_ = 0;
    int a_ = 0;
    int b_ = 0;
    double h_ = 0;
    std::array<JointRow, 5> rows_;
    int count_ = 0;
    std::vector<JointRows> coupled_;   // of a gear
    std::optional<double> constant_{}; // of a gear: its sum when it came into being
};

} // namespace trembler
