// The recent causes of each body's motion, kept while tracing is on.
#pragma once

#include "physics/dynamics/core/joints.hpp"
#include "physics/dynamics/properties/motion_causes.hpp"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace trembler {

/// A cause of a body's motion is also a cause for all bodies that are joined to it or touch it at that time:
/// a plank that a magnet pulls carries the ball on it along. Fixed bodies pass no causes on.
class CauseBook {
public:
    static constexpr std::size_t most =
        16; ///< causes per body; the oldest that no longer acts is dropped first
    static constexpr std::size_t reach = 64; ///< bodies that one event is passed on to

    /// To be called before held calls are drained: no cause is acting until act() is called for it.
    void startActing(std::size_t slots);
    /// A held call acts on a body.
    void act(SlotIndex slot, EventId cause);
    /// An event affected a body once.
    void note(SlotIndex slot, EventId cause);
    /// Passes new causes on to bodies that touch or are joined.
    void spread(BodyTable const& bodies, JointTable const& joints, std::span<TouchingPair const> touching);
    void forget(SlotIndex slot);

    /// The causes of two bodies' motion (or of one), ascending, without repeats; none for noSlot.
    [[nodiscard]] std::vector<EventId> of(SlotIndex a, SlotIndex b = noSlot) const;
    /// Whether any body has other causes than when this was asked last.
    [[nodiscard]] bool takeChanged() { return std::exchange(changed_, false); }

private:
    struct Cause {
        EventId event;
        bool acting = false;
    };
    struct News {
        SlotIndex slot;
        EventId event;
    };
    /// Returns whether it was new.
    bool insert(SlotIndex slot, EventId event, bool acting);

    std::vector<std::vector<Cause>> causes_; // by slot
    std::vector<News> news_;
    bool changed_ = true; // what was listed by another engine's book is outdated
};

} // namespace trembler
