// Constraints of an island that hold exactly, solved all at once.
#pragma once

#include "physics/dynamics/engines/native/contact.hpp"
#include "physics/dynamics/engines/substepped/joint_rows.hpp"

#include <map>
#include <memory>
#include <span>
#include <vector>

namespace trembler::native {

/// The share of a constraint in the motion of one body.
struct ExactTerm {
    SlotIndex slot = noSlot; ///< noSlot: what does not move
    Vec2 linear;
    double angular = 0;
};

/// A row of the Jacobian, with its impulse.
struct ExactRow {
    std::array<ExactTerm, 4> terms;
    int count = 0;
    bool active = true;    ///< an inactive row has no impulse
    bool contact = false;  ///< of a point of contact, not of a joint
    bool oneSided = false; ///< its impulse must not be negative
    double error = 0;      ///< m or rad
    double impulse = 0;    ///< N s or N m s, in this substep
};

/// Solves J W M⁻¹ Jᵀ x = r by a sparse LDLᵀ factorisation, whose symbolic part is kept as long as the same
/// bodies are connected in the same way. W states by how much a body follows an impulse. Constraints that say
/// the same share the load by their proximal solution, unless contacts are among them. For trees and rings of
/// n joints the cost is about linear in n.
class ExactRows {
public:
    ExactRows();
    ~ExactRows();
    ExactRows(ExactRows const&) = delete;
    ExactRows& operator=(ExactRows const&) = delete;

    [[nodiscard]] std::vector<ExactRow>& rows() { return rows_; }
    /// Prepares solve() for the present rows. `states` by slot, `follows` likewise. Returns whether it could:
    /// a net so dense that it would take long is refused.
    [[nodiscard]] bool factorise(std::span<MovingState const> states, std::span<double const> follows);
    /// Whether some of the present rows followed from others when they were prepared last.
    [[nodiscard]] bool wereRedundant();
    /// One unknown for each row; those of inactive rows are 0.
    [[nodiscard]] std::span<double const> solve(std::span<double const> right);
    /// To be called once in a step: forgets what islands that are no more have left.
    void tidy();

private:
    struct Factor;
    Factor& factorOfRows();

    std::vector<ExactRow> rows_;
    std::map<SlotIndex, std::unique_ptr<Factor>> factors_; // by the first body of the island
    Factor* factor_ = nullptr;
    std::vector<std::uint32_t> signature_;
};

} // namespace trembler::native
