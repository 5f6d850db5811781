// Contacts, piece by piece: for engines that only report the contacts of a step.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <functional>

namespace trembler {

/// Two pieces that touch.
struct PieceContact {
    std::uint64_t key = 0; ///< names the pair for as long as it touches; see pieceKey()
    SlotIndex slotA = noSlot;
    SlotIndex slotB = noSlot;
    ContactPatch patch; ///< whose a < b
};

/// One piece of the body in a slot; an engine may make up to three out of one of ours.
[[nodiscard]] constexpr std::uint32_t pieceName(SlotIndex slot, std::size_t piece) {
    return slot << 10 | static_cast<std::uint32_t>(piece); // maximumPieces is 256
}
[[nodiscard]] constexpr SlotIndex slotOfPiece(std::uint32_t piece) {
    return piece >> 10;
}
[[nodiscard]] constexpr std::uint64_t pieceKey(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
}

/// Keeps the contacts of a world from substep to substep and notes which begin and which end.
class TouchRecord {
public:
    /// Takes in the contacts that a substep found, in any order; empties `found`. A contact that was there
    /// and was not found has ended, unless `rests` says that it was not looked for, as both its bodies are
    /// asleep or fixed.
    void take(std::vector<PieceContact>& found, std::function<bool(PieceContact const&)> const& rests);
    /// Ends all contacts of a body that is going away.
    void remove(SlotIndex slot);
    /// Ascending by key.
    [[nodiscard]] std::span<PieceContact const> contacts() const { return contacts_; }
    [[nodiscard]] std::vector<TouchChange>& changes() { return changes_; }

    void noteImpacts(bool wanted);
    void startStep() { impacts_.clear(); }
    /// Finds the impacts of a substep that began `since` (s) after the frame did, after take(). `inverseMass`
    /// is by slot.
    void findImpacts(double since, std::function<double(SlotIndex)> const& inverseMass);
    [[nodiscard]] std::span<Impact const> impacts() const { return impacts_; }

private:
    void change(PieceContact const& contact, int delta);

    std::vector<PieceContact> contacts_;
    std::vector<PieceContact> merged_; // kept for its memory
    std::vector<TouchChange> changes_;
    bool impactsWanted_ = false;
    ImpactBook pressures_;
    std::vector<Impact> impacts_;
};

} // namespace trembler
