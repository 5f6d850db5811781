// Keeps contacts between substeps: for engines that only report the contacts of the current step.
#pragma once

#include "physics/dynamics/engines/impact_budget.hpp"

#include <functional>

namespace trembler {

/// Two pieces that touch.
struct PieceContact {
    std::uint64_t key = 0; ///< identifies the pair while it touches; see pieceKey()
    SlotIndex slotA = noSlot;
    SlotIndex slotB = noSlot;
    ContactPatch patch; ///< with a < b
};

/// Name of one piece of the body in a slot; an engine may make up to three shapes from one piece of a level.
[[nodiscard]] constexpr std::uint32_t pieceName(SlotIndex slot, std::size_t piece) {
    return slot << 10 | static_cast<std::uint32_t>(piece); // maximumPieces is 256
}
[[nodiscard]] constexpr SlotIndex slotOfPiece(std::uint32_t piece) {
    return piece >> 10;
}
[[nodiscard]] constexpr std::uint64_t pieceKey(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
}

/// Keeps the contacts of a world from substep to substep and records which begin and which end.
class TouchRecord {
public:
    /// Records the contacts that a substep found, in any order; empties `found`. A known contact that was not
    /// found has ended, unless `rests` returns true for it, which means that it was not searched for.
    void take(std::vector<PieceContact>& found, std::function<bool(PieceContact const&)> const& rests);
    /// Ends all contacts of a body that is removed.
    void remove(SlotIndex slot);
    /// The current contacts, ascending by key.
    [[nodiscard]] std::span<PieceContact const> contacts() const { return contacts_; }
    [[nodiscard]] std::vector<TouchChange>& changes() { return changes_; }

    void noteImpacts(bool wanted);
    void startStep() { impacts_.clear(); }
    [[nodiscard]] bool impactsWanted() const { return impactsWanted_; }
    /// What finding impacts needs to know of the bodies.
    struct ImpactScene {
        std::size_t slots = 0;
        /// The body in a slot at the beginning of the substep.
        std::function<ImpactBudget::Body(SlotIndex)> before;
        /// The kinetic energy, in J, that the movable body in a slot has lost in the substep.
        std::function<double(SlotIndex)> lost;
        /// The slots of bodies that joints connect; one of the two may be noSlot.
        std::vector<std::pair<SlotIndex, SlotIndex>> joined;
    };
    /// Finds the impacts of a substep that began `since` (s) after the step's beginning; call after take().
    void findImpacts(double since, ImpactScene const& scene);
    [[nodiscard]] std::span<Impact const> impacts() const { return impacts_; }

private:
    void change(PieceContact const& contact, int delta);

    std::vector<PieceContact> contacts_;
    std::vector<PieceContact> merged_; // a member to reuse its memory
    std::vector<TouchChange> changes_;
    bool impactsWanted_ = false;
    ImpactBook pressures_;
    ImpactBudget budget_;
    std::vector<Impact> impacts_;
};

} // namespace trembler
